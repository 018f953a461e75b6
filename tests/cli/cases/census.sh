# The table of what malformed files get.
mkdir meshes
"$WINNOW" generate part --faces 100 -o meshes/b.stl -q
head -c 300 meshes/b.stl >meshes/cut.stl
: >meshes/empty.ply
"$DATA/../../tools/census" --program "$WINNOW" meshes
