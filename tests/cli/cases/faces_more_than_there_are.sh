# More faces than the input has detail for: the count reached is said, and why.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --faces 1M --refine none
