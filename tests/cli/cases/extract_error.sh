# A level within an error, as a length and as a part of the diagonal; one that no level of a lattice keeps is refused, and two targets are.
cp "$DATA"/*whale*.ply.zst scan.ply.zst
"$WINNOW" progressive scan.ply.zst -o scan.wpm -q
"$WINNOW" extract scan.wpm -o part.ply --error 0.1%
"$WINNOW" extract scan.wpm -o length.ply --error 0.002 -q
"$WINNOW" compare scan.ply.zst length.ply --fail-above 0.002 -q && echo near
"$WINNOW" progressive scan.ply.zst -o lattice.wpm --bits 8 -q
code=0; "$WINNOW" extract lattice.wpm -o none.ply --error 1e-6 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" extract scan.wpm -o none.ply --error 1% --faces 10k 2>&1 || code=$?; echo "=> $code"
ls
