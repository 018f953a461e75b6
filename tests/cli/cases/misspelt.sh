# A word that is spelled wrong is named, and so is the nearest that exists.
try() { { "$WINNOW" "$@" 2>&1 || true; } | head -1; }
try simplfy in.ply -o out.ply
try Simplify in.ply
try SIMPLIFY in.ply
try INFO in.ply
try comprae a.ply b.ply
try in.ply -o out.ply
try $'\e[31mred'
try simplify in.ply -o out.ply --facs 10
try simplify in.ply --ouput out.ply
try simplify in.ply -o out.ply --cell 1 --placment=mean
try simplify in.ply -o out.ply --cell 1 --unheard-of
try simplify in.ply -o out.ply --cell 1 --refine qadric
try convert in.ply -o out.ply more.ply
