# A count is a whole number, whatever its unit.
"$WINNOW" simplify none.ply -o small.ply --grid 1.5
