// What there is to know of each split that was applied, to take it back and to read it again.
import { grown, roomFor } from "./grown.js";

export class StepLog {
  constructor(width) {
    this.width = width;
    this.count = 0;
    this.kind = new Uint8Array(0);
    this.moves = new Uint8Array(0);
    this.cursor = new Int32Array(0);  // where its ring began, or its varints
    this.anchor = new Int32Array(0);
    this.newVertices = new Int32Array(0);
    this.restored = new Int32Array(0);
    this.before = new Int32Array(0);  // the anchor's words
  }

  push(kind, cursor, split, words) {
    const at = this.count++;
    if (at === this.kind.length) this.reserve(roomFor(at + 1, at));
    this.kind[at] = kind;
    this.moves[at] = split.moves ? 1 : 0;
    this.cursor[at] = cursor;
    this.anchor[at] = split.anchor;
    this.newVertices[at] = split.newVertices;
    this.restored[at] = split.restored;
    if (!split.moves) return;
    const { width } = this;
    for (let k = 0; k < width; ++k)
      this.before[width * at + k] = words[width * split.anchor + k];
  }

  reserve(steps) {
    for (const name of ["kind", "moves", "cursor", "anchor", "newVertices", "restored"])
      this[name] = grown(this[name], steps);
    this.before = grown(this.before, this.width * steps);
  }
}
