# What is no mesh that is read is refused by the name of what it is.
try() { local code=0; "$WINNOW" simplify "$1" -o small.ply --cell 1 2>&1 || code=$?; echo "=> $code"; }
printf 'OFF BINARY\n\1\2\3\0\0\0' >binary.off
printf '# a comment\n' >empty.obj
printf 'Costly reader,\n' >letter.stl
printf '' >nothing.ply
head -c 60 /dev/zero >short.stl
printf 'v 0 0 0\n' | gzip -n | gzip -n >twice.obj.gz
printf 'v 0 0 0\n' | zstd -q | gzip -n >twice.gz
for file in binary.off empty.obj letter.stl nothing.ply short.stl twice.obj.gz twice.gz; do try "$file"; done
[[ ! -e small.ply ]]
