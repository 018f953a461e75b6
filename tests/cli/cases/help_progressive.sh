"$WINNOW" progressive --help
