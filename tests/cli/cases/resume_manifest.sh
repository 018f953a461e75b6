# A manifest that cannot be read ends the run at once.
try() { local code=0; timeout 20 "$WINNOW" resume kept 2>&1 || code=$?; echo "=> $code"; }
"$WINNOW" generate scan --faces 2000 -o scan.ply -q
"$WINNOW" simplify scan.ply -o small.ply --faces 100 --checkpoint kept --keep-checkpoint -q
manifest=$(find kept -type f -name '*manifest*' | head -1)
rm "$manifest"
mkfifo "$manifest"
try
rm "$manifest"
mkdir "$manifest"
try
rmdir "$manifest"
ln -s /dev/zero "$manifest"
try
