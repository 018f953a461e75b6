# With --strict the first bad face ends the run, and is named.
"$WINNOW" simplify "$DATA/bad_faces.ply" -o small.ply --cell 0.5 --strict || code=$?
[[ ! -e small.ply ]]
exit "$code"
