# The plan: what is read, in which order, how the budget is divided, what scratch and time it takes. Nothing is
# written.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" generate scan --faces 20000 -o scan.stl -q
plan() { echo "# $*"; "$WINNOW" simplify "$@" -o small.ply --threads 2 --dry-run; }
plan scan.ply --cell 0.1
plan scan.stl --grid 100
plan - --faces 5000 --refine none < <(cat scan.stl)
ls
