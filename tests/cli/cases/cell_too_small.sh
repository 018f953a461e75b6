# More cells than the lattice has: the smallest that work are named.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --cell 1e-9
