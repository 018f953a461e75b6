# Others script on these: what was asked for, what refinement did, and what ended it.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
report() {
  echo "# $*"
  "$WINNOW" simplify scan.ply -o small.ply --force --json "$@" >report.json
  tr -d '\n' <report.json | grep -oE '"(output|target|refine)": *\{ *("faces"|"cost"|"file")[^}]*\}' |
    sed -E 's/ +/ /g; s/"file": "[^"]*", "format": "[^"]*", //; s/"(vertices|bytes|max_error)": [0-9.e-]+/"\1": N/g'
}
report --faces 2000
report --ratio 5.005%
report --error 0.01
report --faces 2000 --refine none
report --grid 20
