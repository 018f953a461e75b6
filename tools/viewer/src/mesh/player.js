// A progressive file that is played: splits are applied to its base up to some count, and taken
// back.
import { Damaged } from "../file/damaged.js";
import { Split } from "./split.js";
import { SplitMesh } from "./split_mesh.js";
import { SplitReader, beginning } from "./split_reader.js";
import { StepLog } from "./step_log.js";

const stepsBetweenLooks = 128;  // at the clock

export class Player {
  // Reads the base.
  static async open(file) {
    const player = new Player(file);
    for (let number = 0; number < file.header.baseChunks; ++number) {
      while (!(player.reader.chunk = file.chunk(number))) await file.fetch(number);
      player.reader.goTo(beginning);
      while (!player.reader.atEnd()) player.applyNext(number);
    }
    player.chunk = file.header.baseChunks;
    player.reader.goTo(beginning);
    player.reader.chunk = null;
    file.readAhead(player.chunk);
    return player;
  }

  constructor(file) {
    this.file = file;
    this.mesh = new SplitMesh(file.words.width, file.header.full);
    this.reader = new SplitReader();
    this.split = new Split();
    this.log = new StepLog(file.words.width);
    this.chunk = 0;  // that the next split is in
    this.ends = [];  // of each chunk that was played: where its last split ended
    this.splits = file.header.chunks.slice(file.header.baseChunks)
      .reduce((sum, { splits }) => sum + splits, 0);
    this.problem = null;  // why it goes no further
  }

  get faces() {
    return this.mesh.faceCount;
  }

  // That could still be applied.
  get splitsLeft() {
    return this.splits - this.log.count;
  }

  // Applies the next split. "done" at full count, "waits" while its chunk is not here, or "stops"
  // where the file is damaged or ends, see `problem`.
  forward(mostFaces = Infinity) {
    const state = this.ready();
    if (state !== "ready") return state;
    const { reader, log } = this;
    const steps = log.count;
    try {
      if (this.faces + reader.nextFaces() > mostFaces) return "done";
      const kind = reader.kind();
      const cursor = reader.cursor(kind);
      reader.read(this.mesh, this.split);
      log.push(kind, cursor, this.split, this.mesh.words);
      this.applySplit(this.chunk);
    } catch (error) {
      log.count = steps;
      reader.unread();
      return this.stop(named(error, this.chunk));
    }
    return "moved";
  }

  // Takes the last split back. "done" at the base.
  backward() {
    const { log, mesh, reader } = this;
    if (log.count === 0) return "done";
    const at = --log.count;
    const moves = log.moves[at] !== 0;
    const newVertices = log.newVertices[at];
    mesh.takeBack(log.anchor[at], newVertices, log.restored[at], moves, log.before,
      log.width * at);
    while (reader.at.split === 0) {
      reader.goTo(this.ends[--this.chunk]);
      reader.chunk = null;
    }
    reader.stepBack(log.kind[at], log.cursor[at], newVertices + (moves ? 1 : 0));
    return "moved";
  }

  // Goes to the most faces that are no more than this, or towards it until the clock says
  // `deadline`. Gives what forward() gives last; "moved": there is more to do.
  goTo(faces, deadline = Infinity) {
    for (let steps = 1; this.faces > faces && this.log.count > 0; ++steps) {
      this.backward();
      if (steps % stepsBetweenLooks === 0 && performance.now() > deadline) return "moved";
    }
    for (let steps = 1; ; ++steps) {
      const state = this.forward(faces);
      if (state !== "moved") return state;
      if (steps % stepsBetweenLooks === 0 && performance.now() > deadline) return "moved";
    }
  }

  // Goes there, whatever has to be read.
  async reach(faces) {
    for (;;) {
      const state = this.goTo(faces);
      if (state !== "waits") return state;
      await this.file.fetch(this.chunk);
    }
  }

  // Whether the reader is at the next split.
  ready() {
    const { file, reader } = this;
    while (!reader.chunk || reader.atEnd()) {
      if (reader.chunk) {
        this.ends[this.chunk++] = reader.where();
        reader.goTo(beginning);
        reader.chunk = null;
      }
      if (this.chunk === file.header.chunks.length) return "done";
      try {
        reader.chunk = file.chunk(this.chunk);
      } catch (error) {
        return this.stop(error);
      }
      file.readAhead(this.chunk + 1);
      if (!reader.chunk) return "waits";
    }
    return "ready";
  }

  stop(problem) {
    this.problem = problem;
    return "stops";
  }

  // While the base is read nothing is logged.
  applyNext(number) {
    try {
      this.reader.read(this.mesh, this.split);
      this.applySplit(number);
    } catch (error) {
      throw named(error, number);
    }
  }

  applySplit(number) {
    const { end } = this.file.header.chunks[number];
    if (this.mesh.vertexCount + this.split.newVertices > end.vertices ||
        this.mesh.faceCount + this.split.restored > end.faces)
      throw new Damaged("it brings back more than it should");
    this.mesh.apply(this.split);
  }
}

function named(error, number) {
  return error instanceof Damaged && !error.message.startsWith("chunk")
    ? new Damaged(`chunk ${number} is damaged: ${error.message}`) : error;
}
