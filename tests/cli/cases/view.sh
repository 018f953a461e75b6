# A page with a mesh in it is written, also of a mesh that is no progressive file; an existing page, a missing and a damaged input, and a third mesh are refused; scratch is left empty.
"$WINNOW" generate scan --faces 5k -o scan.ply -q
"$WINNOW" progressive scan.ply -o scan.wpm --base 100 -q
"$WINNOW" view scan.wpm --export page.html
grep -c '<script type="application/base64" data-mesh="scan.wpm">iVdQTQ0K' page.html
mkdir scratch
"$WINNOW" view scan.wpm scan.ply --export two.html -q --scratch scratch
ls scratch
grep -o 'data-mesh="[^"]*"' two.html
code=0; "$WINNOW" view scan.wpm --export page.html 2>&1 || code=$?; echo "=> $code"
"$WINNOW" view scan.wpm --export page.html --force --json | grep '"page"'
code=0; "$WINNOW" view none.wpm --export none.html 2>&1 || code=$?; echo "=> $code"
head -c 100 scan.ply >cut.ply
code=0; "$WINNOW" view cut.ply --export none.html --scratch scratch 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" view scan.wpm scan.wpm scan.wpm --export none.html 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" view scan.wpm --export no/such/folder.html 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" view scan.wpm --port 99999 2>&1 || code=$?; echo "=> $code"
ls . scratch
