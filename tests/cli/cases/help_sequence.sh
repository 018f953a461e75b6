"$WINNOW" sequence --help
