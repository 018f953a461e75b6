# An input is never replaced, whatever name leads to it, and standard input and output are files as well.
"$WINNOW" generate scan --faces 1000 -o scan.ply -q
cp scan.ply copy.ply
ln scan.ply hard.ply
ln -s scan.ply link.ply
try() { local code=0; "$@" 2>&1 || code=$?; echo "=> $code"; }
for output in scan.ply ./scan.ply hard.ply link.ply; do
  try "$WINNOW" simplify scan.ply -o "$output" --grid 10 --force
  try "$WINNOW" convert scan.ply -o "$output" --force
done
try "$WINNOW" simplify copy.ply link.ply -o scan.ply --grid 10 --force
try "$WINNOW" convert - -o scan.ply --force <scan.ply
code=0
"$WINNOW" convert scan.ply -o - >>scan.ply || code=$?
echo "=> $code"
try "$WINNOW" compare scan.ply copy.ply --colored scan.ply --force
try "$WINNOW" compare scan.ply copy.ply --colored copy.ply --force
cmp scan.ply copy.ply
ls -A
