# What a person gets to read.
"$WINNOW" generate scan --faces 20000 -o scan.ply
"$WINNOW" simplify scan.ply -o small.ply --grid 50
