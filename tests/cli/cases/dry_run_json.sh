# Others script on these keys.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --faces 500 --dry-run --json >plan.json
grep -oE '^ *"[^"]+":' plan.json
grep -E '"(faces|vertices)":' plan.json
[[ ! -e small.ply ]]
