# Faces that cannot take part are counted and left out, and said.
cat >bad.ply <<'PLY'
ply
format ascii 1.0
element vertex 6
property float x
property float y
property float z
element face 6
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
nan 1 1
5 5 5
3 0 1 2
3 0 2 3
3 0 1 1
3 0 1 9
3 0 1 4
3 0 3 1
PLY
"$WINNOW" simplify bad.ply -o small.ply --cell 0.5
"$WINNOW" simplify bad.ply -o small.ply --cell 0.5 --force --json | grep -A 4 bad_faces
