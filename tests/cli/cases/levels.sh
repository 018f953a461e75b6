# Several counts in one run: a file for each, named by what it was asked for; what cannot be told apart is refused.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o 'lod-{faces}.ply' --faces 500,5k,2000 | grep -E '^  (faces|level)'
"$WINNOW" simplify scan.ply -o 'part-{ratio}.stl' --ratio 10%,0.02 --json |
  tr -d '\n' | grep -oE '"output": *\{ *"file": "part-[^"]*"' | sed -E 's/ +/ /g'
"$WINNOW" simplify scan.ply -o 'near-{error}.obj' --error 1%,0.1% -q
"$WINNOW" simplify scan.ply -o 'one-{faces}.ply' --faces 1k -q
ls
"$WINNOW" simplify scan.ply -o 'never-{faces}.ply' --faces 3k,300 --dry-run | grep -A2 -E '^outputs| more time'
try() { local code=0; "$WINNOW" simplify scan.ply "$@" 2>&1 || code=$?; echo "=> $code"; }
try -o - --faces 1k,100
try -o small.ply --faces 1k,100
try -o 'never-{faces}.ply' --ratio 10%,1%
try -o 'never-{faces}.ply' --faces 1k,1000
try -o 'never-{faces}.ply' --faces 1k,,100
try -o 'never-{faces}.ply' --faces 1,000
try -o 'never-{error}.ply' --error 0.1,1%
try -o 'never-{faces}.ply' --faces 1k,100 --refine none
try -o 'never-{cell}.ply' --cell 1,2
ls never* 2>/dev/null || true
