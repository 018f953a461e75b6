// Small meshes of kinds that scans are not.
import { writeFileSync } from "node:fs";

// far.ply, of doubles; soup.ply, of faces in one another; colored.ply.
export function makeMeshes(run) {
  run("generate", "terrain", "--faces", "9k", "--offset", "431000,5412000,300", "-o", "far.ply",
    "-q", "--force");
  // Tetrahedra that share vertices now and then, and vertices with a colour and a number.
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const grid = (n) => Array.from({ length: n * n }, (_, i) => [i % n, Math.floor(i / n)]);
  const soup = Array.from({ length: 400 }, () =>
    Array.from({ length: 3 }, () => Math.round(7 * random())).join(" "));
  const tetrahedra = Array.from({ length: 300 }, () =>
    Array.from({ length: 4 }, () => Math.floor(400 * random())));
  const faces = tetrahedra.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d], [a, d, b], [b, d, c]]);
  writePly("soup.ply", [], soup, faces);
  const n = 40;
  const colored = grid(n).map(([x, y]) => `${x} ${y} ${Math.sin(x / 5) * 4} ${6 * x} ${5 * y} 9 ` +
    `${x * 0.125 - y}`);
  const cells = grid(n - 1).map(([x, y]) => x + n * y);
  writePly("colored.ply", ["uchar red", "uchar green", "uchar blue", "float quality"], colored,
    cells.flatMap((v) => [[v, v + 1, v + n], [v + 1, v + n + 1, v + n]]));
}

function writePly(name, properties, vertices, faces) {
  writeFileSync(name, ["ply", "format ascii 1.0", `element vertex ${vertices.length}`,
    ...["float x", "float y", "float z", ...properties].map((words) => `property ${words}`),
    `element face ${faces.length}`, "property list uchar int vertex_indices", "end_header",
    ...vertices, ...faces.map((face) => `3 ${face.join(" ")}`), ""].join("\n"));
}
