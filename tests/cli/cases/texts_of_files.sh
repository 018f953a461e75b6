# Texts that files hold (names, words, comments, and the names of the files) reach a terminal without
# codes, line ends and kilobytes: in reports, in errors and as JSON.
code=$'\e[31mRED\e]0;x\a\b\x7f\x9b31m\xc2\x9b31m\u202e\u2028'
long=$(printf 'N%.0s' {1..5000})
triangle=$'0 0 0\n1 0 0\n0 1 0\n'
vertices=$'v 0 0 0\nv 1 0 0\nv 0 1 0\n'

# Names files of each format that hold the text $1, in all places where one may stand.
files_with() {
  local text=$1 head=$'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n'
  local list=$'element face 1\nproperty list uchar int vertex_indices\n'
  printf 'ply\ncomment %s\nobj_info %s\nformat ascii 1.0\n%s%send_header\n%s3 0 1 2\n' \
    "$text" "$text" "${head#*1.0?}" "$list" "$triangle" >comment.ply
  printf '%sproperty float %s\n%selement %s 1\nproperty int %s\nend_header\n%s3 0 1 2\n7\n' \
    "$head" "$text" "$list" "$text" "$text" "${triangle//$'\n'/$' 4\n'}" >names.ply
  printf '%selement %s 9999999999\nproperty int i\nend_header\n' "$head" "$text" >short.ply
  printf '%s%send_header\n0 0 %s\n' "$head" "$list" "$text" >number.ply
  printf 'ply\nformat %s 1.0\n' "$text" >format.ply
  printf '%sproperty %s q\n' "$head" "$text" >type.ply
  printf '%s%s vertex 3\n' "$head" "$text" >keyword.ply
  printf '# %s\nmtllib %s\no %s\ng %s\n%susemtl %s\nf 1 2 3\n' \
    "$text" "$text" "$text" "$text" "$vertices" "$text" >names.obj
  printf '%sf 1 2 %s\n' "$vertices" "$text" >corner.obj
  printf '%sv 0 0 %s\n' "$vertices" "$text" >number.obj
  printf 'OFF # %s\n3 1 0\n%s3 0 1 2 %s\n' "$text" "$triangle" "$text" >names.off
  printf 'OFF\n3 %s 0\n' "$text" >count.off
  printf 'OFF\n3 1 0\n%s3 0 1 %s\n' "$triangle" "$text" >corner.off
  printf 'Vertex %s 0 0 0\nVertex 2 0 0 1 {%s}\nFace 1 1 2 3\n' "$text" "$text" >number.m
  local facet=$'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1'
  printf 'solid %s\n%s 0\nendloop\nendfacet\nendsolid %s\n' "$text" "$facet" "$text" >names.stl
  printf 'solid a\n%s %s\nendloop\nendfacet\nendsolid\n' "$facet" "$text" >number.stl
  printf '%-80.80s\1\0\0\0%36s' "$text" '' | tr ' ' '\0' >binary.stl
  head -c 14 /dev/zero >>binary.stl
  local json=${text//$'\e'/\\u001b}
  json=${json//$'\a'/\\u0007}
  json=${json//$'\b'/\\b}
  json=${json//$'\x9b31m\xc2'/\\u009b$'\xc2'}
  for member in "\"extensionsRequired\":[\"$json\"]" "\"meshes\":\"$json\"" "\"$json\":[}" \
    "\"buffers\":[{\"byteLength\":36,\"uri\":\"$json\"}]"; do
    printf '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],%s,%s}' \
      '"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]' \
      "$member" >"${#member}.gltf"
  done
  printf '{"asset":{"version":"%s"}}' "$json" >version.gltf
  { printf '\x1f\x8b\x08\x18\0\0\0\0\0\x03%s\0%s\0' "$text" "$text"
    gzip -nc names.obj | tail -c +11; } >named.obj.gz
  head -c -9 named.obj.gz >cut.obj.gz
  cp names.obj "${text:0:200}.obj"
  cp number.obj "bad ${text:0:200}.obj"
}

# Says what of a stream is not fit for a terminal: `$1 $2` is its name.
check() {
  LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]' "$3" &&
    echo "$1 $2: codes" || true
  iconv -f UTF-8 -t UTF-16 "$3" >/dev/null 2>&1 || echo "$1 $2: no UTF-8"
  (($(LC_ALL=C awk '{ if (length > n) n = length } END { print n + 0 }' "$3") <= $4)) ||
    echo "$1 $2: a line of more than $4 bytes"
}

for text in "$code" "$long"; do
  mkdir files
  cd files
  files_with "$text"
  for input in *; do
    for words in info "convert -o out.obj" "simplify -o out.ply --cell 0.1" \
      "simplify -o out.ply --faces 1 --dry-run" "info --json" "convert -o out.ply --json" \
      "simplify -o out.off --cell 0.1 --attributes nothing"; do
      code=0
      "$WINNOW" ${words%% *} "$input" $([[ $words != *" "* ]] || echo "${words#* }") \
        >../out 2>../err </dev/null || code=$?
      ((code == 0 || code == 2 || code == 3)) || echo "$words: $code"
      # A name in JSON is whole.
      check "$input" "$words" ../out $([[ $words == *json* ]] && echo 12000 || echo 1700)
      check "$input" "$words" ../err 1700
      ((code == 0 || $(wc -l <../err) <= 2)) || echo "$input $words: many lines"
      rm -f out.*
    done
  done
  # What the names do not keep from being read.
  for input in names.obj names.off names.stl named.obj.gz comment.ply; do
    "$WINNOW" info "$input" | grep -c 'faces       1$'
  done
  cd ..
  rm -r files
done
