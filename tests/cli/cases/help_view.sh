"$WINNOW" view --help
