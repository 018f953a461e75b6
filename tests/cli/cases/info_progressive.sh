# Of a progressive file in a pipe, and of a compressed one, info tells what it tells of the file itself.
"$WINNOW" generate scan --faces 5k -o scan.ply -q
"$WINNOW" progressive scan.ply -o scan.wpm --base 100 -q
"$WINNOW" info scan.wpm >file
cat scan.wpm | "$WINNOW" info - | diff file -
gzip -c scan.wpm >scan.wpm.gz
"$WINNOW" info scan.wpm.gz | diff file -
gzip -c scan.wpm | "$WINNOW" info - --json | grep '"file"\|"faces"' | head -2
cat scan.ply | "$WINNOW" info - | head -2
head -c 100 scan.wpm >cut.wpm
code=0; cat cut.wpm | "$WINNOW" info - 2>&1 || code=$?; echo "=> $code"
