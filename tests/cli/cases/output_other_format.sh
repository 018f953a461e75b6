# A PLY under the name of another format would surprise whoever opens it; with --to it is what was asked for.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
for name in small.gltf small.3mf small.ply.xz small.gltf.gz; do
  code=0
  "$WINNOW" simplify scan.ply -o "$name" --grid 10 -q 2>&1 || code=$?
  echo "=> $code"
done
"$WINNOW" simplify scan.ply -o SMALL.STL.GZ --grid 10 -q
gzip -dc SMALL.STL.GZ | "$WINNOW" info - | head -1
"$WINNOW" simplify scan.ply -o >(cat >small.pipe) --grid 10 -q; wait $!
head -n 1 small.pipe
"$WINNOW" simplify scan.ply -o small.mesh --grid 10 --to ply -q
ls
