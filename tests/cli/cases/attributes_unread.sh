# What formats hold besides and is not read is named in one note, by `info` and by `convert`, too.
cat >in.obj <<'OBJ'
mtllib in.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vn 0 0 1
vt 0 0
usemtl stone
f 1/1/1 2/1/1 3/1/1 4/1/1
OBJ
printf 'STNOFF\n4 1 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 0 0\n1 1 0 0 0 1 0 0\n0 1 0 0 0 1 0 0\n4 0 1 2 3 255 0 0\n' >in.off
printf 'Vertex 1 0 0 0 {rgb=(1 0 0)}\nVertex 2 1 0 0\nVertex 3 0 1 0\nFace 1 1 2 3 {mat=3}\n' >in.m
cat >in.gltf <<'GLTF'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"TANGENT":2},"material":0}]}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"componentType":5126,"count":3,"type":"VEC2"},{"componentType":5126,"count":3,"type":"VEC4"}],"materials":[{}]}
GLTF
for input in in.obj in.off in.m in.gltf; do
  echo "$input"
  "$WINNOW" simplify "$input" -o out.ply --cell 0.1 --force | grep -E 'carried|note'
  "$WINNOW" info "$input" | grep also
  "$WINNOW" convert "$input" -o out.ply --force | grep note
  "$WINNOW" simplify "$input" -o out.ply --cell 0.1 --force --attributes none | grep note || true
done
"$WINNOW" simplify in.obj in.off -o out.ply --cell 0.1 --force | grep note
