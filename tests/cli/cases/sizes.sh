# Sizes are powers of 1024, whatever their unit is called.
"$WINNOW" generate scan --faces 1000 -o scan.ply -q
plan() { "$WINNOW" simplify scan.ply -o small.ply --faces 100 --dry-run --memory "$1"; }
for size in 1GB 1gb 1GiB 1024M 1024MB 1048576kB; do
  diff <(plan 1G) <(plan "$size")
done
"$WINNOW" info scan.ply --memory 1GX
