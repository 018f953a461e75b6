// What is seen of a mesh, in numbers without gaps: vertices without a face are left out.
export function snapshot(mesh, words) {
  const numbers = new Int32Array(mesh.vertexCount).fill(-1);
  const vertices = [];
  for (let v = 0; v < mesh.vertexCount; ++v) {
    if (!mesh.hasFaces(v)) continue;
    numbers[v] = vertices.length;
    vertices.push(v);
  }
  const corners = new Uint32Array(3 * mesh.faceCount);
  for (let f = 0; f < mesh.faceCount; ++f) {
    for (let i = 0; i < 3; ++i) corners[3 * f + i] = numbers[mesh.vertexOf(f, i)];
  }
  return {
    words,
    corners,
    vertexCount: vertices.length,
    faceCount: mesh.faceCount,
    coordinate: (v, axis) => words.coordinate(mesh.words, words.width * vertices[v], axis),
    number: (v, attribute) => words.number(mesh.words, words.width * vertices[v], attribute),
    colorByte: (v, k) => words.colorByte(mesh.words, words.width * vertices[v], k)
  };
}
