"$DATA/../../tools/check-floors" "$DATA/floors"
