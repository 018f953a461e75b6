"$WINNOW" simplify none.ply -o small.ply --grid 10
