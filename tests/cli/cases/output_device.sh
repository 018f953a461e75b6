# What is no regular file is written straight and needs no --force.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o /dev/null --grid 10 -q
[[ -c /dev/null ]]
"$WINNOW" simplify scan.ply -o /dev/full --grid 10
