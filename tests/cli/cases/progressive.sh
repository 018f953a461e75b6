# A progressive file is made, told of, and extracted from; a count below the base, a cut file, a mesh, and names that say another format are refused.
cp "$DATA"/*whale*.ply.zst scan.ply.zst
"$WINNOW" progressive scan.ply.zst -o scan.wpm --base 500
"$WINNOW" info scan.wpm
"$WINNOW" extract scan.wpm -o small.ply --faces 12345
"$WINNOW" extract scan.wpm -o - --ratio 10% -q | "$WINNOW" convert - -o - --to off -q >piped.off
head -2 piped.off
code=0; "$WINNOW" progressive scan.ply.zst -o scan.wpm 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" extract scan.wpm -o less.ply --faces 100 2>&1 || code=$?; echo "=> $code"
head -c 100000 scan.wpm >cut.wpm
code=0; "$WINNOW" extract cut.wpm -o less.ply --faces 100k 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" extract scan.ply.zst -o less.ply --faces 100 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" simplify scan.wpm -o less.ply --faces 100 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" extract scan.wpm -o less.ply 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" progressive scan.ply.zst -o none.wpm --refine none 2>&1 || code=$?; echo "=> $code"
ls
code=0; "$WINNOW" simplify scan.ply -o other.wpm --faces 100 2>&1 || code=$?; echo "=> $code"
for name in other.ply other.xyz other.glb.gz; do
  code=0; "$WINNOW" progressive scan.ply -o $name 2>&1 || code=$?; echo "=> $code"
done
