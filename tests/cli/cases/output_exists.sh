"$WINNOW" generate scan --faces 2000 -o scan.ply -q
touch small.ply
"$WINNOW" simplify scan.ply -o small.ply --grid 10
