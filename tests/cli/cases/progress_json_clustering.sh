# The same where faces are only clustered.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --faces 500 --refine none --progress json -q
