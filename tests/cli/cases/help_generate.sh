"$WINNOW" generate --help
