// What is seen as a file in one of these formats.
import { glbOf } from "./glb.js";
import { plyOf } from "./ply.js";
import { snapshot } from "./snapshot.js";
import { mOf, objOf } from "./text.js";

const writers = { ply: plyOf, glb: glbOf, obj: objOf, m: mOf };

export function blobOf(mesh, words, format) {
  return writers[format](snapshot(mesh, words));
}

export function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
