# A distance above the limit ends with 1, for pipelines; the report is the same, and says so.
"$WINNOW" generate scan --faces 20000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --error 0.1% -q
compare() {
  local code=0
  "$WINNOW" compare scan.ply small.ply --samples 20k "$@" 2>err >out || code=$?
  echo "# $* => $code"
  cat err
}
compare --fail-above 0.1% -q
compare --fail-above 0.0001% -q
compare --fail-above 1 -q
compare --fail-above 0.000001
grep -c distance out
compare --fail-above 0 --json
grep -A 3 fail_above out | grep exceeded
compare --json
grep '"fail_above"' out
code=0
"$WINNOW" compare scan.ply scan.ply --fail-above 0 -q || code=$?
echo "the same => $code"
compare --fail-above -1
compare --fail-above 1mm
