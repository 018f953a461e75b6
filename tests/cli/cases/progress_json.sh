# A line of JSON for each sign of life, on standard error.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --faces 500 --progress json -q
