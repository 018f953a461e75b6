"$DATA/../../tools/check-layers" "$DATA/layers"
