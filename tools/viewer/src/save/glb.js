// GLB: positions as floats, beside an offset where they are doubles, and colours as light.
const float = 5126, uint = 5125, triangles = 4;

export function glbOf(shot) {
  const { form, hasColors } = shot.words;
  const corners = shot.corners;
  const low = [0, 0, 0];
  if (form.doubles) low.forEach((_, axis) => { low[axis] = Math.floor(least(shot, axis)); });
  const positions = new Float32Array(3 * shot.vertexCount);
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  for (let v = 0; v < shot.vertexCount; ++v) {
    for (let axis = 0; axis < 3; ++axis) {
      const x = positions[3 * v + axis] = shot.coordinate(v, axis) - low[axis];
      min[axis] = Math.min(min[axis], Math.fround(x));
      max[axis] = Math.max(max[axis], Math.fround(x));
    }
  }
  const parts = [corners, positions];
  const accessors = [
    { bufferView: 0, componentType: uint, count: corners.length, type: "SCALAR" },
    { bufferView: 1, componentType: float, count: shot.vertexCount, type: "VEC3", min, max }];
  const attributes = { POSITION: 1 };
  if (hasColors) {
    parts.push(Float32Array.from({ length: 3 * shot.vertexCount }, (_, i) =>
      lightOf(shot.colorByte(Math.floor(i / 3), i % 3) / 255)));
    accessors.push({ bufferView: 2, componentType: float, count: shot.vertexCount, type: "VEC3" });
    attributes.COLOR_0 = 2;
  }
  let byteOffset = 0;
  const bufferViews = parts.map((part, i) => {
    const view = { buffer: 0, byteOffset, byteLength: part.byteLength,
      target: i === 0 ? 34963 : 34962 };
    byteOffset += part.byteLength;
    return view;
  });
  const node = low.some((x) => x !== 0) ? { mesh: 0, translation: low } : { mesh: 0 };
  return packed({
    asset: { version: "2.0", generator: "winnow" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [node],
    meshes: [{ primitives: [{ attributes, indices: 0, mode: triangles }] }],
    accessors,
    bufferViews,
    buffers: [{ byteLength: byteOffset }]
  }, parts, byteOffset);
}

function least(shot, axis) {
  let low = Infinity;
  for (let v = 0; v < shot.vertexCount; ++v) low = Math.min(low, shot.coordinate(v, axis));
  return low;
}

function lightOf(srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : ((srgb + 0.055) / 1.055) ** 2.4;
}

function packed(json, parts, binaryBytes) {
  let text = JSON.stringify(json);
  text = text.padEnd(Math.ceil(text.length / 4) * 4);
  const words = (...numbers) => Uint32Array.from(numbers);
  const jsonChunk = [words(text.length, 0x4e4f534a), text];
  const binaryChunk = [words(binaryBytes, 0x004e4942), ...parts];
  const bytes = 12 + 8 + text.length + 8 + binaryBytes;
  return new Blob([words(0x46546c67, 2, bytes), ...jsonChunk, ...binaryChunk]);
}
