// The page begins here. What it shows first is a part of the page, or named in its address:
// ?mesh=scan.wpm, and ?beside=other.wpm for a second one.
import { ProgressiveFile } from "./file/progressive_file.js";
import { EmbeddedSource, WebSource } from "./file/sources.js";
import { Unpacker } from "./file/unpacker.js";
import { Controls } from "./page/controls.js";
import { Viewer } from "./page/viewer.js";

function firstSources() {
  const sources = Array.from(document.querySelectorAll("script[data-mesh]"), (mesh) =>
    ({ source: new EmbeddedSource(mesh.dataset.mesh, mesh.textContent), beside: true }));
  const asked = new URLSearchParams(location.search);
  for (const name of ["mesh", "beside"]) {
    if (asked.has(name))
      sources.push({ source: new WebSource(asked.get(name)), beside: name === "beside" });
  }
  return sources;
}

const unpacker = new Unpacker();

// They are read while the browser makes its picture ready, which may take a second.
const first = firstSources().map(({ source, beside }) => {
  const file = ProgressiveFile.open(source, unpacker);
  file.catch(() => {});  // told of when it is shown
  return { source, beside, file };
});

async function begin() {
  const controls = new Controls(unpacker);
  let viewer = null;
  try {
    viewer = new Viewer(document.getElementById("canvas"), () => controls.show());
  } catch {
    controls.say("This browser cannot draw meshes: WebGL is missing or switched off.");
    return;
  }
  controls.bind(viewer);
  globalThis.viewer = viewer;  // for whoever drives the page
  for (const { source, beside, file } of first) await controls.open(source, beside, file);
  // Behind the first picture, which it would hold up.
  requestAnimationFrame(() => setTimeout(startWorker));
}

function startWorker() {
  try {
    // UNPACK_WORKER: its text, by bundle.mjs.
    const script = new Blob([UNPACK_WORKER], { type: "text/javascript" });
    unpacker.use(new Worker(URL.createObjectURL(script)));
  } catch {
    // Then chunks are unpacked here.
  }
}

begin();
