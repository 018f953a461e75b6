# -q: not a word, wherever the mesh goes.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --grid 10 -q
"$WINNOW" simplify scan.ply -o - --grid 10 -q >piped.ply
"$WINNOW" generate scan --faces 2000 -o - -q >again.ply
cmp small.ply piped.ply
cmp scan.ply again.ply
