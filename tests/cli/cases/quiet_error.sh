# -q silences reports, not errors.
"$WINNOW" simplify none.ply -o small.ply --grid 10 -q
