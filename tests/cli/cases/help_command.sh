# "help COMMAND" says the same as "COMMAND --help".
for command in simplify resume convert info compare generate; do
  diff <("$WINNOW" help $command) <("$WINNOW" $command --help)
done
diff <("$WINNOW" help) <("$WINNOW" --help)
"$WINNOW" help simplfy
