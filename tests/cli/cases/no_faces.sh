# A file without a face is refused, whichever way the cell is found.
printf '%s\n' ply 'format ascii 1.0' 'element vertex 1' 'property float x' 'property float y' 'property float z' \
  'element face 0' 'property list uchar int vertex_indices' end_header '1 2 3' >points.ply
head -c 84 /dev/zero >none.stl
printf 'solid a\nendsolid a\n' >ascii.stl
for file in points.ply none.stl ascii.stl; do
  for how in '--cell 1' '--grid 3' '--faces 10' '--ratio 0.1'; do
    code=0
    "$WINNOW" simplify "$file" -o small.ply $how 2>&1 || code=$?
    echo "=> $code"
  done
done | sort | uniq -c
ls small.ply 2>/dev/null || true
