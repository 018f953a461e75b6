# Normals are written when asked for, and when the input has them.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o plain.ply --grid 10 -q
"$WINNOW" simplify scan.ply -o asked.ply --grid 10 --normals -q
"$WINNOW" simplify asked.ply -o kept.ply --grid 5 -q
for file in plain asked kept; do
  echo "$file: $(head -n 12 $file.ply | grep -ac 'property float n[xyz]' || true)"
done
