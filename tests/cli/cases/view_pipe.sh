# A progressive file in a pipe, and a compressed one, is shown as it is.
"$WINNOW" generate scan --faces 5k -o scan.ply -q
"$WINNOW" progressive scan.ply -o scan.wpm --base 100 -q
gzip -c scan.wpm >scan.wpm.gz
"$WINNOW" view scan.wpm --export file.html -q
cat scan.wpm | "$WINNOW" view - --export pipe.html -q
"$WINNOW" view scan.wpm.gz --export packed.html -q
data() { grep -o '<script type="application/base64" data-mesh="[^"]*">[^<]*' "$1" | sed 's/.*">//'; }
for page in pipe packed; do cmp <(data file.html) <(data $page.html) && echo "$page: the same"; done
