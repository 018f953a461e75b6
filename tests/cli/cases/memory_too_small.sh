# Said at once, with what would do.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --grid 10 --threads 2 --memory 1M
