# With --json an error is a report on standard output as well; where a mesh goes there, on standard error.
try() { echo "# $*"; local code=0; "$WINNOW" "$@" --json 2>err || code=$?; echo "=> $code"; cat err; }
try simplify missing.ply -o small.ply --grid 10
try simplify missing.ply -o - --grid 10
