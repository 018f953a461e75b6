# A reader that has seen enough of the help or of a report is no error.
set -o pipefail
for command in "" simplify resume convert info compare generate; do
  "$WINNOW" $command --help | true
done
"$WINNOW" generate scan --faces 1000 -o scan.ply | true
"$WINNOW" info scan.ply | true
