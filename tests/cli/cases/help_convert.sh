"$WINNOW" convert --help
