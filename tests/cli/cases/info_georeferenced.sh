# A box far from the origin is told as finely as one at the origin.
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n431000.125 5412000.5 300\n431001.125 5412000.5 300\n431000.125 5412002.001 300\n3 0 1 2\n' >far.ply
"$WINNOW" info far.ply
