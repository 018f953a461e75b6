# No line of help is longer than 100 columns.
for command in "" simplify resume convert info compare generate; do
  "$WINNOW" $command --help | awk 'length > 100'
done
