"$WINNOW" simplify --help
