# No line of progress is longer than the terminal is wide.
"$WINNOW" generate scan --faces 300k -o scan.ply -q
for columns in 20 40 80 200; do
  script -qc "stty cols $columns; $WINNOW simplify scan.ply -o small.ply --faces 20k --detail full --force --progress always -q" /dev/null </dev/null |
    tr '\r' '\n' | grep -a $'\e\[K' | sed -E 's/\x1b\[K//g' |
    awk -v most=$columns 'length >= most {print most ": " $0} /%/ {seen = 1} END {print most, seen ? "shown" : "none"}'
done
