# What vertices carry comes along; what cannot is named, and a name that is none is a usage error.
cat > in.ply <<'PLY'
ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
property float s
property float t
property double quality
element face 6
property list uchar int vertex_indices
property int label
element edge 1
property int vertex1
end_header
0 0 0 255 0 0 0 0 1.5
1 0 0 255 0 0 0 0 1.5
1 1 0 255 0 0 0 0 1.5
0 1 0 255 0 0 0 0 1.5
0.5 0.5 1 255 0 0 0 0 1.5
3 0 2 1 7
3 0 3 2 7
3 0 1 4 7
3 1 2 4 7
3 2 3 4 7
3 3 0 4 7
0
PLY
"$WINNOW" simplify in.ply -o small.ply --faces 6 | grep -E 'carried|note'
"$WINNOW" simplify in.ply -o small.ply --faces 6 --json --force | grep -A 12 '"attributes"'
head -n 12 small.ply | grep -a property
"$WINNOW" simplify in.ply -o small.stl --faces 6 | grep -E 'carried|note'
"$WINNOW" simplify in.ply -o named.ply --faces 6 --attributes colors,s | grep -E 'carried|note'
"$WINNOW" simplify in.ply -o none.ply --faces 6 --attributes none | grep -E 'carried|note' || echo "nothing to say"
for list in colour vertex_indices ''; do
  code=0
  "$WINNOW" simplify in.ply -o never.ply --faces 6 --attributes "$list" 2>&1 || code=$?
  echo "=> $code"
done
"$WINNOW" info in.ply | grep also
# A name may be any bytes.
sed 's/ quality/ caf\xe9/' in.ply >bytes.ply
"$WINNOW" simplify bytes.ply -o bytes_small.ply --faces 6 --json | grep 'caf'
"$WINNOW" info bytes.ply --json | grep -c 'caf'
head -n 12 bytes_small.ply | grep -ac $'property double caf\xe9'
