# A point cloud is named as such by every command that needs faces; info counts its points.
{
  printf '%s\n' ply 'format ascii 1.0' 'element vertex 1024' 'property float x' 'property float y' \
    'property float z' end_header
  for i in {1..1024}; do echo "$i 0 1"; done
} >points.ply
sed -n '/end_header/,$s/^[0-9]/v &/p' points.ply >points.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >face.obj
try() { local code=0; "$WINNOW" "$@" 2>&1 || code=$?; echo "=> $code"; }
try simplify points.ply -o small.ply --cell 1
try simplify points.obj -o small.ply --faces 100
try convert points.ply -o other.stl
cat >points.gltf <<'GLTF'
{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"mode":0}]}],
"accessors":[{"componentType":5126,"count":512,"type":"VEC3"}]}
GLTF
try convert points.gltf -o other.stl
try compare face.obj points.ply
"$WINNOW" info points.obj | grep -E 'faces|vertices' | head -2
ls small.ply other.stl 2>/dev/null || true
