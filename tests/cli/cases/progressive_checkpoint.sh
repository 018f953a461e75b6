# A progressive file with a checkpoint, kept; taken up again it has nothing to do; without the file it is written anew.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" progressive scan.ply -o plain.wpm -q
"$WINNOW" progressive scan.ply -o scan.wpm --checkpoint kept --keep-checkpoint -q
"$WINNOW" resume kept --keep-checkpoint | grep resumed
mv scan.wpm first.wpm
"$WINNOW" resume kept --json | grep -A 5 '"resumed"'
cmp plain.wpm first.wpm
cmp plain.wpm scan.wpm
code=0; "$WINNOW" resume kept 2>&1 || code=$?; echo "=> $code"
