# Others script on these keys.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --grid 50 -q
"$WINNOW" compare scan.ply small.ply --samples 10k --json >report.json
grep -oE '^ *"[^"]+":' report.json
