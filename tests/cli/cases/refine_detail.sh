# Without a word all faces of a small input are refined; with --detail it is clustered first.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
for detail in "" "--detail full" "--detail 3"; do
  "$WINNOW" simplify scan.ply -o small.ply --force --json --faces 1000 $detail >report.json
  grep -E '"(cell_size|cells|cluster_passes)"' report.json
done
