# A sequence with a checkpoint, kept; taken up again it has nothing to do; without a frame all are written anew.
"$WINNOW" generate scan --faces 2000 -o f-1.ply -q
"$WINNOW" generate scan --faces 2000 -o f-2.ply -q
"$WINNOW" sequence f-1.ply f-2.ply -o 'plain-{frame}.ply' --faces 200 -q
"$WINNOW" sequence f-1.ply f-2.ply -o 's-{frame}.ply' --faces 200 --checkpoint kept --keep-checkpoint -q
"$WINNOW" resume kept --keep-checkpoint | grep resumed
rm s-2.ply f-1.ply
"$WINNOW" resume kept --json | grep -A 5 '"resumed"'
cmp plain-1.ply s-1.ply
cmp plain-2.ply s-2.ply
code=0; "$WINNOW" resume kept 2>&1 || code=$?; echo "=> $code"
