# One share of the whole run, which never goes back and ends at all of it.
"$WINNOW" generate scan --faces 200k -o scan.ply -q
"$WINNOW" generate part --faces 50k -o part.stl -q
shares() {
  "$WINNOW" "$@" --progress json -q 2>&1 >/dev/null |
    sed -E 's/.*"share":([0-9.e-]+).*/\1/' |
    awk -v of="$1" '$1 < last || $1 > 1 {print "goes back", last, $1} {last = $1}
                    END {print of, (NR > 0 && last == 1 ? "good" : last)}'
}
shares simplify scan.ply -o small.ply --faces 20k
shares simplify part.stl -o small.stl --ratio 10% --weld 0.001%
shares convert part.stl -o part.ply
shares info scan.ply
shares compare scan.ply small.ply --samples 100k
shares generate scan --faces 2M -o other.ply
