"$WINNOW" --help
