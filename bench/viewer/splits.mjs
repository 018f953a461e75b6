// Plays a progressive file up and down again and again, without a page.   node splits.mjs FILE
import { openAsBlob, readFileSync } from "node:fs";
import { ProgressiveFile } from "../../tools/viewer/src/file/progressive_file.js";
import { FileSource } from "../../tools/viewer/src/file/sources.js";
import { Player } from "../../tools/viewer/src/mesh/player.js";
import { unpackerInThread } from "./unpacking.mjs";

const rounds = 4;
// Of this thread, in milliseconds: other programs do not count, nor does the worker.
const processorTime = () =>
  Number(readFileSync("/proc/thread-self/schedstat", "utf8").split(" ")[0]) / 1e6;

const source = new FileSource(await openAsBlob(process.argv[2]));
const file = await ProgressiveFile.open(source, await unpackerInThread());
const player = await Player.open(file);
const best = { up: Infinity, elapsed: Infinity, down: Infinity, splits: 0 };
for (let round = 0; round < rounds; ++round) {
  const begin = processorTime(), from = performance.now();
  if (await player.reach(Infinity) === "stops") throw player.problem;
  const top = processorTime();
  best.elapsed = Math.min(best.elapsed, performance.now() - from);
  best.splits = player.log.count;
  player.goTo(0);
  best.up = Math.min(best.up, top - begin);
  best.down = Math.min(best.down, processorTime() - top);
}
const rate = (milliseconds) => best.splits / milliseconds * 1000;
console.log(JSON.stringify({ splits: best.splits, up: rate(best.up), elapsed: rate(best.elapsed),
  down: rate(best.down) }));
process.exit();  // the worker would go on
