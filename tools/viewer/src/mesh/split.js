// One step from coarse to fine: brings vertices and faces back, and hands faces over to the first
// of the new vertices. One is used again and again.
import { grown, roomFor } from "./grown.js";

export const noVertex = -1;

export class Split {
  constructor() {
    this.anchor = noVertex;  // the vertex that was kept
    this.moves = false;  // the anchor gets other words
    this.newVertices = 0;
    this.words = new Int32Array(64);  // of the anchor, where it moves, then of the new ones
    this.moved = 0;  // faces that are handed over, as their corners (3 f + i) at the anchor
    this.corners = new Int32Array(128);
    this.far = new Int32Array(0);  // or as their other two corners: then corners are still unknown
    this.byFar = false;
    this.restored = 0;  // faces that were gone
    this.faces = new Int32Array(24);
  }

  reserve(words, moved, restored) {
    const room = (array, length) => grown(array, roomFor(length, array.length));
    this.words = room(this.words, words);
    this.corners = room(this.corners, moved);
    if (this.byFar) this.far = room(this.far, 2 * moved);
    this.faces = room(this.faces, 3 * restored);
  }
}
