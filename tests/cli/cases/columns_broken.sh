# tools/check-columns names lines that are too long, in characters, and nothing else.
mkdir -p here/docs here/src here/tests/cli/cases
long=$(printf 'ä%.0s' {1..101})
echo 'ColumnLimit: 102' >here/.clang-format
printf '%s\n' "${long#ä}" "$long" >here/README.md
printf '%s\n' "$long" "| $long |" >here/docs/malformed.md
echo "$long" >here/tests/cli/cases/help.out
echo "$long" >here/tests/cli/cases/message.out
printf '%s\n' "${long}ä" "${long}ää" >here/src/one.cpp
"$DATA/../../tools/check-columns" here
