# Files of any formats are one model; what cannot be read twice is refused; a box keeps what lies wholly in it.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n' >left.obj
printf 'OFF\n4 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n4 0 1 2 3\n' >right.off
"$WINNOW" simplify left.obj right.off -o both.ply --cell 0.1 --json | grep -E '"(faces|vertices)"'
"$WINNOW" info both.ply | grep -E 'box|edges'
"$WINNOW" simplify left.obj right.off -o crop.ply --cell 0.1 --crop -1,-1,-1,1.5,1,1 | grep -E '^  (faces|cropped)'
"$WINNOW" info crop.ply | grep box
try() { local code=0; "$WINNOW" simplify "$@" -o never.ply --cell 0.1 2>&1 || code=$?; echo "=> $code"; }
try left.obj - <right.off
try left.obj missing.off
try left.obj --crop 0,0,0,1,1
try left.obj --crop 1,0,0,0,1,1
try left.obj --crop 5,5,5,6,6,6
"$WINNOW" simplify left.obj right.off -o never.ply --faces 4 --dry-run | head -5
[[ ! -e never.ply ]]
