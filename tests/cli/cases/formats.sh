# The output's name says which format it is, --to where it does not; content says what the input is, whatever its name.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" generate scan --faces 2000 -o scan.stl -q
"$WINNOW" simplify scan.ply -o a.STL --grid 10 -q
"$WINNOW" simplify scan.ply -o - --grid 10 --to stl -q >b
"$WINNOW" simplify scan.ply -o c --grid 10 -q
cmp a.STL b
head -c 3 c; echo
cp scan.stl really.ply
"$WINNOW" simplify really.ply -o d.ply --grid 10 -q
"$WINNOW" simplify scan.stl -o e.ply --grid 10 --from stl -q
cmp d.ply e.ply
"$WINNOW" simplify scan.stl -o f.ply --grid 10 --from ply
