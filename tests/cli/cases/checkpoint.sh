# A run with a checkpoint, kept; taken up again it has nothing to do; without the output it is written anew.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o plain.ply --faces 1k -q
"$WINNOW" simplify scan.ply -o small.ply --faces 1k --checkpoint kept --keep-checkpoint -q
"$WINNOW" resume kept --keep-checkpoint | grep resumed
mv small.ply first.ply
"$WINNOW" resume kept --json | grep -A 5 '"resumed"'
cmp plain.ply first.ply
cmp plain.ply small.ply
ls kept
"$WINNOW" resume kept
