# No terminal, no bar.
"$WINNOW" generate scan --faces 20000 -o scan.ply >made.txt
"$WINNOW" simplify scan.ply -o small.ply --faces 500 >summary.txt
