# Twelve processes that start on one output at once: each ends with 0 or a clear refusal, the output
# is that of one alone, and nothing else is left.
"$WINNOW" generate scan --faces 5000 -o in.ply -q
"$WINNOW" simplify in.ply -o small.ply --faces 500 -q

# Runs "$WINNOW" twelve times with these words, the last of which is the output.
twelve() {
  local out=${*: -1} run code done=0
  mkdir kept
  "$WINNOW" "$@" -q && mv "$out" kept/alone
  for run in {1..12}; do
    { code=0; "$WINNOW" "$@" -q 2>"kept/err.$run" || code=$?; echo "$code" >"kept/code.$run"; } &
  done
  wait
  for run in {1..12}; do
    code=$(<"kept/code.$run")
    if ((code == 0)); then
      done=$((done + 1))
      [[ ! -s kept/err.$run ]] || { echo "0, but:"; cat "kept/err.$run"; }
    else
      [[ $code == 2 && $(<"kept/err.$run") == "winnow: '$out' exists; use --force to replace it" ]] ||
        { echo "$code:"; cat "kept/err.$run"; }
    fi
  done
  [[ " $* " == *" --force "* || $done == 1 ]] || echo "$done are done"
  [[ " $* " != *" --force "* || $done == 12 ]] || echo "only $done with --force"
  cmp "$out" kept/alone
  rm -r kept "$out"
  [[ $(ls -A | tr '\n' ' ') == 'in.ply small.ply ' ]] || ls -A
}
twelve simplify in.ply --faces 1000 -o out.ply
twelve simplify in.ply --faces 1000 --force -o out.ply
twelve simplify in.ply --grid 20 -o out.obj.gz
twelve convert in.ply -o out.glb
twelve convert in.ply --force -o out.stl
twelve generate scan --faces 5000 -o out.ply
twelve compare in.ply small.ply --colored out.ply
twelve compare in.ply small.ply --picture out.png
