# With -o - the mesh has standard output to itself; the summary goes to standard error.
"$WINNOW" generate scan --faces 2000 -o - 2>generated.txt | "$WINNOW" simplify - -o - --grid 10 >small.ply
head -c 3 small.ply; echo
grep -q ' made ' generated.txt
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small2.ply --grid 10 -q
cmp small.ply small2.ply
"$WINNOW" simplify scan.ply -o - --grid 10 --json 2>report.json >small3.ply
cmp small.ply small3.ply
head -n 2 report.json
