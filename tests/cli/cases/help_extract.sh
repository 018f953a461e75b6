"$WINNOW" extract --help
