# The browser is told to open the address, where there is a desktop; else a line says to. A signal
# ends the server, and that is no failure.
"$WINNOW" generate scan --faces 5k -o scan.ply -q
"$WINNOW" progressive scan.ply -o scan.wpm --base 100 -q
"$WINNOW" view scan.wpm --export page.html -q || exit 1  # built without the viewer
mkdir bin
printf '#!/bin/sh\necho "$1" >opened.part\nmv opened.part opened\n' >bin/xdg-open
chmod +x bin/xdg-open
# serve FILE: runs until FILE is there.
serve() {
  "$WINNOW" view scan.wpm >out 2>err &
  for ((i = 0; i < 300; ++i)); do [[ ! -s $1 ]] || break; sleep 0.1; done
  code=0
  kill $!
  wait $! || code=$?
  echo "=> $code"
}
export PATH=$PWD/bin:$PATH
DISPLAY=:0 serve opened
[[ $(sed -n 's/^  address  *//p' out) == $(cat opened) ]]
sed 's/127.0.0.1:[0-9]*/127.0.0.1:PORT/' opened out
unset DISPLAY WAYLAND_DISPLAY
serve err
cat err
