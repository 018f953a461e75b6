"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --grid 10 --scratch nowhere
