# The summary of a sequence; frames in the order of their numbers, results named after them; frames that differ.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nv 0.5 0 0\nf 1 6 5\nf 6 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 1 4 3\nf 1 3 6\nf 6 3 2\n' >f9.obj
sed 's/0.5 0.5 1/0.5 0.5 2/' f9.obj >f10.obj
"$WINNOW" sequence f10.obj f9.obj -o 's-{frame}.obj' --faces 6
grep -c '^f' s-9.obj s-10.obj
diff <(grep '^f' s-9.obj) <(grep '^f' s-10.obj) && echo 'the same faces'
sed 's/f 4 1 5/f 1 4 5/' f9.obj >f11.obj
code=0; "$WINNOW" sequence f9.obj f11.obj -o 't-{frame}.obj' --faces 6 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" sequence f9.obj f10.obj -o t.ply --faces 6 2>&1 || code=$?; echo "=> $code"
"$WINNOW" sequence f9.obj f10.obj -o all.glb --faces 6 -q
"$WINNOW" sequence all.glb -o 'a-{frame}.obj' --faces 6
code=0; "$WINNOW" sequence f9.obj -o t.glb --faces 6 2>&1 || code=$?; echo "=> $code"
code=0; "$WINNOW" sequence f9.obj f10.obj -o 's-{frame}.obj' --faces 6 2>&1 || code=$?; echo "=> $code"
ls
