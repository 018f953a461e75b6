# Faces that cannot take part are counted and left out, and said.
"$WINNOW" simplify "$DATA/bad_faces.ply" -o small.ply --cell 0.5
"$WINNOW" simplify "$DATA/bad_faces.ply" -o small.ply --cell 0.5 --force --json | grep -A 4 '"bad_faces"'
