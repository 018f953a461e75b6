// Binary PLY with all that vertices carry.
const setters = {
  char: [1, "setInt8"], uchar: [1, "setUint8"], short: [2, "setInt16"], ushort: [2, "setUint16"],
  int: [4, "setInt32"], uint: [4, "setUint32"], float: [4, "setFloat32"], double: [8, "setFloat64"]
};

export function plyOf(shot) {
  const { words } = shot;
  const type = words.form.doubles ? "double" : "float";
  const properties = ["x", "y", "z"].map((name) => ({ name, type })).concat(words.attributes);
  const head = ["ply", "format binary_little_endian 1.0", `element vertex ${shot.vertexCount}`,
    ...properties.map((property) => `property ${property.type} ${property.name}`),
    `element face ${shot.faceCount}`, "property list uchar int vertex_indices", "end_header\n"];
  const bytes = properties.reduce((sum, property) => sum + setters[property.type][0], 0);
  const vertices = new DataView(new ArrayBuffer(bytes * shot.vertexCount));
  let at = 0;
  for (let v = 0; v < shot.vertexCount; ++v) {
    for (let i = 0; i < properties.length; ++i) {
      const [size, set] = setters[properties[i].type];
      vertices[set](at, i < 3 ? shot.coordinate(v, i) : shot.number(v, i - 3), true);
      at += size;
    }
  }
  const faces = new DataView(new ArrayBuffer(13 * shot.faceCount));
  for (let f = 0; f < shot.faceCount; ++f) {
    faces.setUint8(13 * f, 3);
    for (let i = 0; i < 3; ++i) faces.setUint32(13 * f + 1 + 4 * i, shot.corners[3 * f + i], true);
  }
  return new Blob([head.join("\n"), vertices, faces]);
}
