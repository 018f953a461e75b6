# No format gets a position that is not finite: what floats cannot hold is refused.
{
  printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n'
  printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
  printf '0 0 0\n1e39 0 0\n0 1e39 0\n3 0 1 2\n'
} >large.ply
try() { local code=0; "$WINNOW" "$@" 2>&1 || code=$?; echo "=> $code"; }
for out in a.stl a.glb; do try convert large.ply -o "$out"; done
try convert large.ply -o b.stl --ascii
for out in a.ply a.obj a.off a.m; do try convert large.ply -o "$out" --positions float; done
try convert large.ply -o a.glb --quantize 12 --compress meshopt
try simplify large.ply -o a.stl --grid 4
try generate scan --faces 1000 -o a.stl --offset 1e39,0,0
for out in b.ply b.obj b.off b.m; do try convert large.ply -o "$out" -q; done
ls
