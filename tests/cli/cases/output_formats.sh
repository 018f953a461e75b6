# Every format by the name's ending, and compressed; what a format lacks is refused before anything is read.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
for name in a.ply a.stl a.obj a.off a.glb a.ply.gz a.obj.zst; do
  "$WINNOW" simplify scan.ply -o "$name" --grid 10 -q
done
head -c 4 a.glb; echo
head -1 a.off
head -1 a.obj
gzip -dc a.ply.gz | cmp - a.ply
"$WINNOW" simplify scan.ply -o - --grid 10 --to glb -q | cmp - a.glb
"$WINNOW" simplify scan.ply -o b.ply --grid 10 --ascii --positions double -q
head -5 b.ply
try() { local code=0; "$WINNOW" simplify none.ply --grid 10 "$@" 2>&1 || code=$?; echo "=> $code"; }
try -o b.glb --ascii
try -o b.stl --positions double
try -o b.obj --positions half
try -o b.ply --compress meshopt
try -o b.glb --to gltf
"$WINNOW" simplify none.ply -o b.glb --faces 400M 2>&1 || true
"$WINNOW" generate scan -o c.glb 2>&1 || true
