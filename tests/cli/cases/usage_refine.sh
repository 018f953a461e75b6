# What refinement cannot do is said in words that name the option, with 2, before any file is looked at.
simplify() { local code=0; "$WINNOW" simplify none.ply -o small.ply "$@" 2>&1 || code=$?; echo "=> $code"; }
echo "# error"
simplify --error 0
simplify --error lots
simplify --error 1 --faces 10
simplify --error 1 --refine none
simplify --error 1 --refine volume
echo "# cells"
simplify --cell 1 --refine quadric
simplify --grid 9 --refine quadric
echo "# detail"
simplify --faces 10 --detail 1
simplify --faces 10 --detail -2
simplify --faces 10 --detail most
simplify --faces 10 --detail 3 --refine none
simplify --cell 1 --detail full
echo "# angle"
simplify --faces 10 --max-normal-deviation 0
simplify --faces 10 --max-normal-deviation 91
simplify --faces 10 --max-normal-deviation flat
echo "# names"
simplify --faces 10 --refine best
simplify --faces 10 --boundary free
simplify --faces 10 --topology none
echo "# topology"
simplify --faces 10 --refine none --topology free
simplify --cell 1 --keep-pieces
echo "# boundary"
simplify --cell 1 --boundary keep
simplify --faces 10 --refine none --boundary keep
[[ -z $(ls) ]]
