// Surfaces of files, to be compared: faces by the places of their corners, whatever their order.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";

// Reads a mesh by way of winnow, as lines of a text PLY.
export function facesOf(winnow, name) {
  const text = `${name}.text.ply`;
  execFileSync(winnow, ["convert", name, "-o", text, "--ascii", "--force", "-q"]);
  const lines = readFileSync(text, "utf8").trimEnd().split("\n");
  const head = lines.indexOf("end_header");
  const count = (element) => Number(lines.find((line) => line.startsWith(`element ${element}`))
    .split(" ")[2]);
  const vertices = lines.slice(head + 1, head + 1 + count("vertex"));
  const faces = lines.slice(head + 1 + vertices.length).map((line) => {
    const corners = line.split(" ").slice(1).map((v) => vertices[v]);
    const first = corners.indexOf([...corners].sort()[0]);
    return [...corners.slice(first), ...corners.slice(0, first)].join(" / ");
  });
  return { vertices: vertices.sort(), faces: faces.sort() };
}
