"$WINNOW" --version
