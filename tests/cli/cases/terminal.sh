# A terminal gets no binary mesh; from one that is read, what is awaited is said.
"$WINNOW" generate scan --faces 8 -o scan.ply -q
terminal() { script -qc "$*" /dev/null </dev/null | tr -d '\r'; }
terminal "$WINNOW simplify scan.ply -o - --grid 1"
terminal "$WINNOW convert scan.ply -o /dev/tty --to stl"
terminal "$WINNOW convert scan.ply -o - -q" | head -1
terminal "$WINNOW generate scan --faces 8 -o - --to obj -q" | grep -c '^f'
terminal "$WINNOW convert scan.ply -o - --ascii --to stl -q" | head -1
script -qc "$WINNOW info - -q" /dev/null <<<$'ply\n\x04' | tr -d '\r' | grep waiting
