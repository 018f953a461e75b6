# What --colored and --picture do not write they refuse by the name's ending, before any work.
try() { local code=0; "$WINNOW" compare missing.ply missing.ply "$@" 2>&1 || code=$?; echo "=> $code"; }
try --picture picture.jpg
try --picture picture.svg
try --picture picture.png.gz
try --colored colored.stl
try --colored colored.glb
try --colored COLORED.PLY
try --picture PICTURE.PNG
