"$WINNOW" info --help
