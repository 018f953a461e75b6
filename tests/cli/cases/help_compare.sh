"$WINNOW" compare --help
