# A page is written as every output: never over what is read, through a link, into a pipe; whoever else's file beside it stays. Options of the server do not go with it, and a file that is cut short is told.
"$WINNOW" generate scan --faces 5k -o scan.ply -q
"$WINNOW" progressive scan.ply -o scan.wpm --base 100 -q
cp scan.ply mesh.ply
for input in scan.wpm mesh.ply; do
  code=0; "$WINNOW" view --export $input $input --force 2>&1 || code=$?; echo "=> $code"
done
cmp scan.ply mesh.ply
echo mine >page.html.part
touch target.html
ln -s target.html page.html
code=0; "$WINNOW" view scan.wpm --export page.html 2>&1 || code=$?; echo "=> $code"
"$WINNOW" view scan.wpm --export page.html --force -q
[[ -L page.html && -s target.html ]]
cat page.html.part
"$WINNOW" view scan.wpm --export - 2>told | cmp - target.html
grep -c page told
code=0; "$WINNOW" view scan.wpm --export /dev/full 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" view scan.wpm --export other.html --port 80 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" view scan.wpm --force 2>&1 || code=$?; echo "=> $code"
head -c 20000 scan.wpm >cut.wpm
"$WINNOW" view cut.wpm --export cut.html -q
ls
