# "help COMMAND" says the same as "COMMAND --help", and so does "--help COMMAND".
for command in simplify resume convert info compare generate; do
  diff <("$WINNOW" help $command) <("$WINNOW" $command --help)
  diff <("$WINNOW" --help $command) <("$WINNOW" $command --help)
  diff <("$WINNOW" -h $command) <("$WINNOW" $command --help)
done
diff <("$WINNOW" help) <("$WINNOW" --help)
diff <("$WINNOW" help help) <("$WINNOW" --help)
"$WINNOW" help simplfy
