# What a script's unset variable leaves is no way to leave an option out.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
for option in --faces --checkpoint --crop; do
  code=0
  "$WINNOW" simplify scan.ply -o small.ply --grid 10 "$option" "" 2>&1 || code=$?
  echo "=> $code"
done
ls
