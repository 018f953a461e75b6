// A sequence in one GLB plays in a browser, by three.js: at each frame's time every vertex is where
// the frame's own file has it, and pictures of different frames differ.
//   WINNOW=... CHROMIUM=... node --test moving_glb.test.mjs
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { build } from "../../tools/viewer/node_modules/esbuild/lib/main.js";
import { launch } from "./browser.mjs";

const { WINNOW: winnow, CHROMIUM: chromium } = process.env;
const run = (...words) => execFileSync(winnow, words, { stdio: ["ignore", "pipe", "inherit"] });
const viewer = join(import.meta.dirname, "../../tools/viewer");
const frames = 10, n = 24;

// A sheet over which a wave runs.
function sheet(frame) {
  const lines = [];
  for (let y = 0; y <= n; ++y) {
    for (let x = 0; x <= n; ++x)
      lines.push(`v ${x / n} ${y / n} ${0.2 * Math.sin(6 * x / n + y / n + 0.5 * frame)}`);
  }
  for (let y = 0; y < n; ++y) {
    for (let x = 1; x <= n; ++x) {
      const v = y * (n + 1) + x;
      lines.push(`f ${v} ${v + 1} ${v + n + 2}`, `f ${v} ${v + n + 2} ${v + n + 1}`);
    }
  }
  return lines.join("\n") + "\n";
}

const player = `
import * as three from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
globalThis.play = async (base64) => {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const { scene, animations } = await new GLTFLoader().parseAsync(bytes.buffer, "");
  const mixer = new three.AnimationMixer(scene);
  mixer.clipAction(animations[0]).setLoop(three.LoopOnce).play();
  mixer.clipAction(animations[0]).clampWhenFinished = true;
  let mesh;
  scene.traverse((node) => { if (node.isMesh) mesh = node; });
  scene.add(new three.HemisphereLight(0xffffff, 0x000000, 3));
  const camera = new three.PerspectiveCamera(60, 1, 0.01, 10);
  camera.position.set(0.5, -0.8, 0.8);
  camera.lookAt(0.5, 0.5, 0);
  const canvas = document.createElement("canvas");
  const renderer = new three.WebGLRenderer({ canvas, preserveDrawingBuffer: true });
  renderer.setSize(160, 160);
  return (time) => {
    mixer.setTime(time);
    renderer.render(scene, camera);
    const place = new three.Vector3();
    const places = [];
    for (let v = 0; v < mesh.geometry.attributes.position.count; ++v)
      places.push(...mesh.getVertexPosition(v, place).applyMatrix4(mesh.matrixWorld));
    return { places, picture: canvas.toDataURL() };
  };
};`;

const placesIn = (name) => readFileSync(name, "utf8").split("\n")
  .filter((line) => line.startsWith("v ")).flatMap((line) => line.slice(2).split(" ").map(Number));

test("a sequence in one GLB plays", async (context) => {
  const names = Array.from({ length: frames }, (_, i) => `moves-${i}.obj`);
  names.forEach((name, i) => writeFileSync(name, sheet(i)));
  run("sequence", ...names, "-o", "moves.glb", "--ratio", "20%", "--force", "-q");
  run("sequence", ...names, "-o", "own-{frame}.obj", "--ratio", "20%", "--force", "-q");
  const { outputFiles } = await build({ stdin: { contents: player, resolveDir: viewer },
    bundle: true, write: false, logLevel: "error" });
  const browser = await launch(chromium);
  context.after(() => browser.close());
  const page = await browser.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.addScriptTag({ content: outputFiles[0].text });
  const at = await page.evaluateHandle((base64) => globalThis.play(base64),
    readFileSync("moves.glb").toString("base64"));
  // Between two frames it goes straight.
  const between = await at.evaluate((show, time) => show(time), 2.5 / 24);
  const [before, behind] = [placesIn("own-2.obj"), placesIn("own-3.obj")];
  assert.ok(between.places.every((x, i) => Math.abs(x - (before[i] + behind[i]) / 2) < 1e-5));
  const pictures = new Set();
  for (let frame = 0; frame < frames; ++frame) {
    const { places, picture } = await at.evaluate((show, time) => show(time), frame / 24);
    const own = placesIn(`own-${frame}.obj`);
    assert.equal(places.length, own.length);
    const off = Math.max(...places.map((x, i) => Math.abs(x - own[i])));
    assert.ok(off < 1e-5, `frame ${frame} is off by ${off}`);
    pictures.add(picture);
  }
  assert.equal(pictures.size, frames);
  assert.deepEqual(errors, []);
});
