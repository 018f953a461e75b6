# A map for each of several results, named as the outputs are; the summary, --json and --dry-run name them.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o 'lod-{faces}.ply' --map 'map-{faces}.npy' --faces 5k,500 |
  grep -E '^  (level|map)'
"$WINNOW" simplify scan.ply -o one.ply --map one.npy --faces 5k | grep -E '^  map'
cmp one.npy map-5000.npy
"$WINNOW" simplify scan.ply -o 'part-{ratio}.ply' --map 'part-{ratio}.npy.gz' --ratio 10%,2% --json |
  grep -oE '"map": "part-[0-9.]*npy.gz"'
"$WINNOW" simplify scan.ply -o 'never-{faces}.ply' --map 'never-{faces}.npy' --faces 3k,300 --dry-run |
  grep -A2 -E '^(outputs|maps)'
code=0; "$WINNOW" simplify scan.ply -o 'never-{faces}.ply' --map map.npy --faces 3k,300 2>&1 || code=$?
echo "=> $code"
ls
