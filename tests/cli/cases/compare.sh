# The coloured mesh is a mesh, and is not written over.
"$WINNOW" generate part --faces 20k -o part.ply -q
"$WINNOW" simplify part.ply -o small.ply --faces 2k --refine none -q
"$WINNOW" compare part.ply small.ply --samples 10k --colored colored.ply
"$WINNOW" info colored.ply
"$WINNOW" compare part.ply small.ply --samples 10k --colored colored.ply 2>/dev/null || echo "ends with $?"
