# The report of a conversion as JSON; where the mesh goes to standard output, on standard error.
"$WINNOW" generate part --faces 3000 -o part.stl -q
"$WINNOW" convert part.stl -o part.glb --json
"$WINNOW" convert part.stl -o - --json >part.ply 2>report
grep -c '"welded": true' report
head -c 3 part.ply; echo
