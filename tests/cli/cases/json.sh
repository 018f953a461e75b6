# Others script on these keys.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --grid 50 --json >report.json
grep -oE '^ *"[^"]+":' report.json
grep -E '"notes"' report.json
