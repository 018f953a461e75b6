# An interrupt that was ignored at the start, as of a job in the background, stays ignored.
"$WINNOW" generate scan --faces 1000 -o scan.ply -q
mkfifo pipe
(trap '' INT; exec "$WINNOW" simplify pipe -o small.ply --grid 10 -q) &
exec 3>pipe
for _ in {1..100}; do ls -A | grep -q winnow- && break; sleep 0.05; done
kill -INT $!
sleep 0.2
cat scan.ply >&3
exec 3>&-
wait $!
ls
