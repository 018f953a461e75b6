// One mesh that is looked at: its file, how far it is played, and its surface.
import { errorOf } from "../file/header.js";
import { Player } from "../mesh/player.js";
import { Surface } from "../draw/surface.js";

export class View {
  // `opening`: a ProgressiveFile.
  static async open(opening, center) {
    const file = await opening;
    return new View(file, await Player.open(file), center ?? centerOf(file.header.box));
  }

  constructor(file, player, center) {
    this.file = file;
    this.name = file.source.name;
    this.player = player;
    this.center = center;
    this.surface = new Surface(player.mesh, file.words, center);
    this.target = Math.min(file.header.full.faces, 1e7);
    this.smallest = player.faces;
    this.rests = false;  // at the target, and drawn
  }

  get faces() {
    return this.player.faces;
  }

  get full() {
    return this.file.header.full.faces;
  }

  get radius() {
    const { low, high } = this.file.header.box;
    return Math.max(Math.hypot(...low.map((x, axis) => high[axis] - x)) / 2, 1e-30);
  }

  // Beside the whole mesh, at most; of the part of the file that the next split is in.
  get error() {
    return errorOf(this.file.header, this.player.chunk);
  }

  goTo(faces) {
    this.target = Math.min(Math.max(faces, this.smallest), this.full);
    this.rests = false;
  }

  // Goes towards the target until the clock says `deadline`; gives what the player says.
  advance(deadline) {
    const state = this.player.goTo(this.target, deadline);
    this.rests = state === "done" || state === "stops";
    return state;
  }

  // One edge is collapsed or rebuilt; gives a text of what changed.
  async step(forward) {
    const { player } = this;
    const { log } = player;
    let state = forward ? player.forward() : player.backward();
    while (state === "waits") {
      await this.file.fetch(player.chunk);
      state = player.forward();
    }
    if (state === "stops") return player.problem.message;
    if (state === "done") return forward ? "This is the whole mesh." : "This is the coarsest mesh.";
    this.target = player.faces;
    this.rests = false;
    return described(forward, log, forward ? log.count - 1 : log.count, player.mesh.vertexCount);
  }
}

function centerOf({ low, high }) {
  return low.map((x, axis) => x + (high[axis] - x) / 2);
}

function described(forward, log, at, vertexCount) {
  const many = (count, name) => `${count.toLocaleString("en")} ${name}${count === 1 ? "" : "s"}`;
  const news = log.newVertices[at];
  const first = forward ? vertexCount - news : vertexCount;
  const which = news === 1 ? `vertex ${first}` : `${news.toLocaleString("en")} vertices`;
  const faces = many(log.restored[at], "face");
  const anchor = log.anchor[at];
  if (anchor < 0) return forward ? `A piece came back: ${which}, ${faces}.`
    : `A piece went: ${which}, ${faces}.`;
  return forward ? `Rebuilt: ${which} was split off vertex ${anchor}; ${faces} came back.`
    : `Collapsed: ${which} went into vertex ${anchor}; ${faces} went.`;
}
