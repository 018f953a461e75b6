// The page begins here. What it shows first is a part of the page, or named in its address:
// ?mesh=scan.wpm, and ?beside=other.wpm for a second one.
import { EmbeddedSource, WebSource } from "./file/sources.js";
import { Controls } from "./page/controls.js";
import { Viewer } from "./page/viewer.js";

const controls = new Controls();
const viewer = new Viewer(document.getElementById("canvas"), () => controls.show());
controls.bind(viewer);
globalThis.viewer = viewer;  // for whoever drives the page

async function openFirst() {
  for (const mesh of document.querySelectorAll("script[data-mesh]"))
    await controls.open(new EmbeddedSource(mesh.dataset.mesh, mesh.textContent), true);
  const asked = new URLSearchParams(location.search);
  for (const name of ["mesh", "beside"]) {
    if (asked.has(name)) await controls.open(new WebSource(asked.get(name)), name === "beside");
  }
}

openFirst();
