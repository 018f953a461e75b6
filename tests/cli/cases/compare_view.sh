# --view takes a name or a direction, and goes with --picture.
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
try() {
  local code=0
  "$WINNOW" compare scan.ply scan.ply --samples 100 --picture p.png --force -q "$@" 2>&1 || code=$?
  echo "$* => $code"
}
try
cp p.png iso.png
for view in iso 1,1,1; do
  try --view $view
  cmp p.png iso.png
done
for view in front top 0,-1,0 1e-300,0,2; do
  try --view $view
  ! cmp -s p.png iso.png || echo same
done
rm p.png
for view in side Front 1,2 1,2,3,4 1,2, 0,0,0 nan,0,0 inf,1,1 "1, 2, 3" "1;2;3" ""; do try --view "$view"; done
"$WINNOW" compare scan.ply scan.ply --view top 2>&1 || echo "=> $?"
"$WINNOW" compare scan.ply scan.ply --samples 100 --view=top --picture - -q >out.png
head -c 4 out.png | tail -c 3; echo
[[ ! -e p.png ]]
