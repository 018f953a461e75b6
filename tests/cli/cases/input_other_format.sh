# What is no PLY and no STL is refused by the name of what it is.
try() { local code=0; "$WINNOW" simplify "$1" -o small.ply --cell 1 2>&1 || code=$?; echo "=> $code"; }
printf 'o thing\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >thing.obj
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >thing.off
printf 'glTF\2\0\0\0' >thing.glb
printf 'Dear reader,\n' >letter.stl
printf '' >nothing.ply
head -c 60 /dev/zero >short.stl
for file in thing.obj thing.off thing.glb letter.stl nothing.ply short.stl; do try "$file"; done
[[ ! -e small.ply ]]
