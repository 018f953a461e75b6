# The summary of a conversion; an existing output is kept, a bad face counted or refused, a pipe read and written.
cp "$DATA"/*whale*.ply.zst scan.ply.zst
"$WINNOW" convert scan.ply.zst -o scan.stl
"$WINNOW" convert scan.stl -o again.ply
code=0; "$WINNOW" convert scan.stl -o again.ply 2>&1 || code=$?; echo "=> $code"
"$WINNOW" convert scan.stl -o again.ply --force -q
"$WINNOW" convert scan.ply.zst -o - -q | "$WINNOW" convert - -o - --to off -q >piped.off
head -3 piped.off
printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar label\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n3 0 1 2\n3 1 1 2\n4 0 1 3 2\n' >bad.ply
"$WINNOW" convert bad.ply -o bad.obj
cat bad.obj
code=0; "$WINNOW" convert bad.ply -o strict.obj --strict 2>&1 || code=$?; echo "=> $code"
ls
