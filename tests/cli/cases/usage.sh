# What is wrong with the options is said in words that name the option, with 2, before any file is looked at.
try() { local code=0; "$WINNOW" "$@" 2>&1 || code=$?; echo "=> $code"; }
simplify() { try simplify none.ply -o small.ply "$@"; }
echo "# how fine"
simplify
simplify --cell 1 --grid 2
simplify --faces 10 --ratio 0.1
echo "# numbers"
simplify --cell abc
simplify --cell 0
simplify --cell -1
simplify --cell nan
simplify --cell 2.5mm
simplify --grid 0
simplify --grid 9M
simplify --grid -5
simplify --faces 3
simplify --faces 1X
simplify --faces 99999999999G
simplify --ratio 0
simplify --ratio 2
simplify --ratio 200%
simplify --ratio -5%
simplify --cell 1 --memory lots
simplify --cell 1 --memory 12XB
simplify --cell 1 --threads 9999
simplify --cell 1 --threads -1
echo "# names"
simplify --cell 1 --from blend
simplify --cell 1 --to fbx
simplify --cell 1 --placement best
simplify --cell 1 --progress sometimes
simplify --cell 1 --scratch nowhere
echo "# what is missing or too much"
simplify --cell 1 --bogus
simplify --cell 1 --cell 2
try simplify none.ply --cell 1
try simplify -o small.ply --cell 1
try
try bogus
try info
try generate scan
try generate cube -o cube.ply
try generate scan -o scan.ply --faces 0
try generate scan -o scan.ply --offset 1,2
try generate scan -o scan.ply --offset 1,2,inf
[[ -z $(ls) ]]
