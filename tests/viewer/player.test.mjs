// What the page reads of a progressive file is what `winnow extract` reads of it.
//   WINNOW=... node --test player.test.mjs     in an empty folder with whale.ply
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { openAsBlob, readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { deflateRawSync, inflateRawSync } from "node:zlib";
import { checksumOf } from "../../tools/viewer/src/file/bytes.js";
import { CutShort, Damaged } from "../../tools/viewer/src/file/damaged.js";
import { headerBytes, parseHeader } from "../../tools/viewer/src/file/header.js";
import { ProgressiveFile } from "../../tools/viewer/src/file/progressive_file.js";
import { EmbeddedSource, FileSource } from "../../tools/viewer/src/file/sources.js";
import { Player } from "../../tools/viewer/src/mesh/player.js";
import { blobOf } from "../../tools/viewer/src/save/save.js";
import { makeMeshes } from "./meshes.mjs";
import { facesOf } from "./surface.mjs";

const { WINNOW: winnow } = process.env;
const run = (...words) => execFileSync(winnow, words, { stdio: ["ignore", "pipe", "inherit"] });
const raw = run("extract", "--help").includes("--raw") ? ["--raw"] : [];

async function play(name) {
  return Player.open(await ProgressiveFile.open(new FileSource(await openAsBlob(name))));
}

function playBytes(bytes) {
  const source = new FileSource(new Blob([bytes]));
  return ProgressiveFile.open(source).then((file) => Player.open(file));
}

async function check(player, name, faces) {
  await player.reach(faces);
  const blob = blobOf(player.mesh, player.file.words, "ply");
  writeFileSync("read.ply", Buffer.from(await blob.arrayBuffer()));
  run("extract", name, "-o", "extracted.ply", "--faces", String(faces), ...raw, "--force", "-q");
  assert.deepEqual(facesOf(winnow, "read.ply"), facesOf(winnow, "extracted.ply"), `${faces}`);
}

const meshes = [
  ["a scan", ["whale.ply"], []],
  ["a lattice", ["whale.ply"], ["--bits", "12"]],
  ["pieces that went", ["soup.ply"], ["--topology", "free", "--base", "4"]],
  ["doubles far away", ["far.ply"], []],
  ["colours and reals", ["colored.ply"], []]
];

makeMeshes(run);
for (const [what, inputs, options] of meshes) {
  test(`${what}: every count, up and down, is that of 'winnow extract'`, async () => {
    const name = `${what.replaceAll(" ", "_")}.wpm`;
    run("progressive", ...inputs, "-o", name, ...options, "--force", "-q");
    const player = await play(name);
    const { base, full } = player.file.header;
    for (const share of [0, 1, 0.01, 0.4]) {
      const faces = Math.max(4, Math.round(base.faces + share * (full.faces - base.faces)));
      await check(player, name, faces);
    }
  });
}

test("taking steps back restores every array", async () => {
  run("progressive", "whale.ply", "-o", "back.wpm", "--force", "-q");
  const player = await play("back.wpm");
  await player.reach(9000);
  const { mesh } = player;
  const state = () => [mesh.words.slice(0, 3 * mesh.vertexCount),
    Array.from({ length: 3 * mesh.faceCount }, (_, i) => mesh.vertexOf((i / 3) | 0, i % 3))];
  const before = state();
  await player.reach(30_000);
  for (let steps = 0; steps < 100; ++steps) assert.equal(player.backward(), "moved");
  await player.reach(100_000);
  assert.equal(player.goTo(9000), "done");
  assert.deepEqual(state(), before);
});

test("a file as base64 is the same file", async () => {
  run("progressive", "whale.ply", "-o", "base64.wpm", "--force", "-q");
  const bytes = readFileSync("base64.wpm");
  const source = new EmbeddedSource("x", bytes.toString("base64"));
  for (const [begin, end] of [[0, 1], [1, 7], [2, 3], [100, 1000], [bytes.length - 1, 1e9]])
    assert.deepEqual(Buffer.from(await source.read(begin, end)), bytes.subarray(begin, end));
});

// The file with other content of one chunk, and all checksums right.
function withChunk(bytes, number, change) {
  const size = headerBytes(bytes);
  const { chunks } = parseHeader(bytes.subarray(0, size));
  const { begin, end } = chunks[number];
  const content = inflateRawSync(bytes.subarray(begin, end.bytes));
  change(content);
  const packed = deflateRawSync(content);
  const whole = Buffer.concat([bytes.subarray(0, begin), packed, bytes.subarray(end.bytes)]);
  const entry = size - 32 * (chunks.length - number);
  whole.writeUInt32LE(packed.length, entry);
  whole.writeUInt32LE(checksumOf(packed), entry + 20);
  whole.writeUInt32LE(0, 16);
  whole.writeUInt32LE(checksumOf(whole.subarray(0, size)), 16);
  return whole;
}

test("hostile files are refused or are meshes", async () => {
  run("generate", "scan", "--faces", "4k", "-o", "small.ply", "--force", "-q");
  run("progressive", "small.ply", "-o", "small.wpm", "--base", "50", "--force", "-q");
  const bytes = readFileSync("small.wpm");
  const { chunks } = parseHeader(bytes.subarray(0, headerBytes(bytes)));
  let seed = 11, refused = 0;
  const random = (below) => (seed = (seed * 48271) % 2147483647) % below;
  for (let i = 0; i < 100; ++i) {
    const changed = withChunk(bytes, random(chunks.length), (content) => {
      for (let k = 0; k < 2; ++k) content[random(content.length)] ^= 1 << random(8);
    });
    try {
      const player = await playBytes(changed);
      if (await player.reach(1e9) === "stops") throw player.problem;
      player.goTo(0);
    } catch (error) {
      if (!(error instanceof Damaged)) throw error;
      ++refused;
    }
  }
  assert.ok(refused > 25, `${refused}`);
});

test("whatever is missing at the end is told", async () => {
  const bytes = readFileSync("small.wpm");
  for (const length of [0, 5, 100, 127, 200, 1000]) {
    await assert.rejects(playBytes(bytes.subarray(0, length)),
      (error) => error instanceof CutShort || error instanceof Damaged, `${length}`);
  }
  const player = await playBytes(bytes.subarray(0, bytes.length - 1));
  assert.equal(await player.reach(1e9), "stops");
  assert.ok(player.problem instanceof CutShort);
  assert.equal(player.goTo(100), "done");
});
