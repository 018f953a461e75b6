# What a script's unset variable leaves is no way to leave an option out.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
for option in --faces --checkpoint --crop; do
  code=0
  "$WINNOW" simplify scan.ply -o small.ply --grid 10 "$option" "" 2>&1 || code=$?
  echo "=> $code"
done
code=0
"$WINNOW" simplify scan.ply -o small.ply --grid 10 --attributes red,,blue 2>&1 || code=$?
echo "=> $code"
# Nor may the next word be taken for the value, and an input for the output.
cp scan.ply other.ply
code=0
"$WINNOW" simplify --output= scan.ply other.ply --grid 10 --force 2>&1 || code=$?
echo "=> $code"
cmp scan.ply other.ply
ls
