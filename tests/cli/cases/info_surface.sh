# What a surface encloses, whether it is closed, and how many parts it has.
cube() {  # X OFFSET [LETTERS]: the faces of a unit cube at X, with vertices from OFFSET on
  for z in 0 1; do for y in 0 1; do for x in 0 1; do echo "v $(($1 + x)) $y $z"; done; done; done
  local at=$2
  for quad in "1 3 4 2" "5 6 8 7" "1 2 6 5" "3 7 8 4" "1 5 7 3" "2 4 8 6"; do
    set -- $quad
    echo "f $(($1 + at)) $(($2 + at)) $(($3 + at)) $(($4 + at))"
  done
}
cube 0 0 >cube.obj
grep -v "f 5 6 8 7" cube.obj >open.obj
awk '/^f/ {print $1, $5, $4, $3, $2; next} {print}' cube.obj >inward.obj
sed 's/f 5 6 8 7/f 7 8 6 5/' cube.obj >mixed.obj
{ cube 0 0; cube 5 8; } >two.obj
{ cube 0 0; cube 1 8 | sed 's/^v \(.\) \(.\) \(.\)/v \1 \2.5 \3.5/'; } >apart.obj
{ cube 0 0; echo "v 9 9 9"; echo "f 1 2 9"; } >fin.obj
{ cube 0 0; sed 's/^v \(.\) \(.\) \(.\)$/v -\1 -\2 -\3/; s/^f .*//' cube.obj; awk '/^f/ {print $1, $5 + 8, $4 + 8, $3 + 8, $2 + 8}' cube.obj; } >corner.obj
"$WINNOW" convert cube.obj -o soup.stl -q
"$WINNOW" info cube.obj open.obj inward.obj mixed.obj two.obj apart.obj fin.obj corner.obj soup.stl |
  grep -E '^[a-z]|watertight|volume|parts'
# A file that cannot be read does not keep the next from being told of.
"$WINNOW" info missing.obj cube.obj | grep -E '^[a-z]|parts'
