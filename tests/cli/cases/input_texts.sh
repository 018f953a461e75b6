# OBJ, OFF and .m by content, whatever their names are, from files, packed and from a pipe.
cat >square.obj <<'END'
# a square and a face that names a vertex too many
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
f 1/1 2/2 3/3 -1
f 1 2 9
END
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 8\n' >square.txt
printf 'Vertex 1 0 0 0\nVertex 3 1 0 0\nVertex 4 1 1 0\nVertex 7 0 1 0\nFace 1 1 3 4 7\nFace 2 1 3 2\n' >square.m
gzip square.m
for file in square.obj square.txt square.m.gz; do
  "$WINNOW" info "$file"
  "$WINNOW" simplify "$file" -o "$file.ply" --cell 0.5 -q
  cmp "$file.ply" square.obj.ply
done
"$WINNOW" simplify - -o - --cell 0.5 --from obj -q <square.obj | cmp - square.obj.ply
cat square.txt | "$WINNOW" simplify - -o - --cell 0.5 -q | cmp - square.obj.ply
