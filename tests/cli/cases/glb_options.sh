# How far quantized positions move, in the summary and in JSON, by both commands; what the options refuse.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" convert scan.ply -o a.glb --quantize 14 --up z | grep -E 'quantized|note'
"$WINNOW" simplify scan.ply -o b.glb --faces 500 --quantize 14 --compress meshopt | grep quantized
"$WINNOW" convert scan.ply -o a.glb --force --quantize 14 --json | grep position_error
"$WINNOW" convert scan.ply -o a.glb --force --quantize 4 | grep -E 'quantized|note'
# What was turned by the node is turned back by nothing: y and z have changed places in what is read.
"$WINNOW" convert scan.ply -o up.glb --up z -q
"$WINNOW" convert up.glb -o up.obj -q
"$WINNOW" convert scan.ply -o scan.obj -q
paste -d' ' <(grep ^v scan.obj) <(grep ^v up.obj) |
  awk '{ if ($2 == $6 && $4 == $7 && -$3 == $8) ++same } END { print same == NR }'
try() { local code=0; "$WINNOW" convert scan.ply "$@" 2>&1 || code=$?; echo "=> $code"; }
try -o c.glb --quantize 17
try -o c.glb --quantize 0
try -o c.glb --quantize many
try -o c.ply --quantize 12
try -o c.stl --up z
try -o c.glb --up x
try -o c.ply --up y -q
