"$WINNOW" resume --help
