# Hoppe's .m is written by both commands, from a name and from --to, and read again as the same mesh.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" convert scan.ply -o scan.m -q
head -1 scan.m | cut -d' ' -f 1-2
grep -m1 Face scan.m | cut -d' ' -f 1-2
"$WINNOW" convert scan.m -o back.ply -q
cmp scan.ply back.ply 2>&1 | grep -c differ || true
"$WINNOW" info back.ply --json >a.json
"$WINNOW" info scan.ply --json >b.json
diff <(grep -E '"(area|vertices|total|boundary)"' a.json) <(grep -E '"(area|vertices|total|boundary)"' b.json) && echo same
"$WINNOW" simplify scan.m -o small.m.gz --faces 500 --json | grep -m1 '"faces"'
gzip -dc small.m.gz | grep -c '^Face'
"$WINNOW" simplify scan.ply -o - --to m --faces 500 -q | "$WINNOW" convert - -o out.obj -q
grep -c '^f' out.obj
