# A model that falls into too few cells has no face left: that is said, and no empty mesh is written.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --grid 1 || code=$?
[[ ! -e small.ply ]]
exit "$code"
