# Standard output has other names than -.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o - --grid 10 -q > usual.ply
"$WINNOW" simplify scan.ply -o /dev/stdout --grid 10 -q | cmp - usual.ply
echo before > redirected
"$WINNOW" simplify scan.ply -o /dev/stdout --grid 10 -q >> redirected
(echo before; cat usual.ply) | cmp - redirected
"$WINNOW" convert scan.ply -o - -q > converted.ply
"$WINNOW" convert scan.ply -o /proc/self/fd/1 -q | cmp - converted.ply
"$WINNOW" compare scan.ply usual.ply --colored /dev/fd/1 -q > colored.ply
head -n 1 colored.ply
"$WINNOW" simplify scan.ply -o /dev/stdout --grid 10 --json 2> report.json | cmp - usual.ply
grep -c '"faces"' report.json
ls
