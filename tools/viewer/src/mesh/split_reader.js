// The splits of a chunk, one after the other. What a split means hangs on the mesh before it.
import { Damaged } from "../file/damaged.js";
import { takeVarint } from "../file/chunk.js";
import { Ring, fetchedAtOnce } from "./ring.js";
import { noVertex } from "./split.js";

// Kinds of splits. Of all but the last two the anchor moves, one vertex is new, and the faces that
// come back have both of them and a neighbour on the left, on the right, on both sides or on none.
// The faces that move are side by side, or told by bits.
const leftSide = 1, rightSide = 2;
const noSideByBits = 3, bothSidesByBits = 4, leftSideByBits = 5, rightSideByBits = 6;
const oneByOne = 7, oneByOneThatMoves = 8;
const restored = [2, 1, 1, 0, 2, 1, 1];  // faces that come back, by kind
const ringBytes = [1, 1, 1, 0, 2, 1, 1];  // that are told of

export const beginning = { split: 0, anchor: 0, ring: 0, count: 0, varint: 0, row: 0 };

function copy(from, to) {
  to.split = from.split;
  to.anchor = from.anchor;
  to.ring = from.ring;
  to.count = from.count;
  to.varint = from.varint;
  to.row = from.row;
}

export class SplitReader {
  constructor() {
    this.ring = new Ring();
    this.varint = { at: 0 };
    this.chunk = null;  // which may be closed while the place in it is kept
    this.at = { ...beginning };  // the next split, and its part of each section
    this.begun = { ...beginning };  // where the last split was read
  }

  goTo(place) {
    copy(place, this.at);
  }

  where() {
    return { ...this.at };
  }

  // Where a split of this kind keeps what has no fixed size.
  cursor(kind) {
    return kind < oneByOne ? this.at.count : this.at.varint;
  }

  // To before a split that was read. `cursor`: what cursor() was then. `rows`: of its words.
  stepBack(kind, cursor, rows) {
    const { at } = this;
    --at.split;
    at.row -= rows;
    if (kind < oneByOne) {
      --at.anchor;
      at.ring -= ringBytes[kind];
      at.count = cursor;
    } else {
      at.varint = cursor;
    }
  }

  atEnd() {
    return this.at.split === this.chunk.kinds.length;
  }

  kind() {
    return this.chunk.kinds[this.at.split];
  }

  // Fills `split` with the next one. What fails, or cannot be applied, is given back by unread().
  read(mesh, split) {
    const kind = this.kind();
    copy(this.at, this.begun);
    if (kind < oneByOne) this.readBeside(mesh, kind, split);
    else if (kind <= oneByOneThatMoves) this.readOneByOne(mesh, kind, split);
    else throw new Damaged("it has a split of no known kind");
    this.readWords(mesh, split);
    ++this.at.split;
  }

  unread() {
    copy(this.begun, this.at);
  }

  // How many faces come back.
  nextFaces() {
    const kind = this.kind();
    if (kind < oneByOne) return restored[kind];
    const cursor = { at: this.at.varint };
    for (let i = 0; i < 3; ++i) takeVarint(this.chunk.varints, cursor);
    return takeVarint(this.chunk.varints, cursor);
  }

  readBeside(mesh, kind, split) {
    const { anchors } = this.chunk;
    const { at, ring } = this;
    if (at.anchor >= anchors.length) throw new Damaged("it has too few anchors");
    if (at.anchor % fetchedAtOnce === 0) ring.fetch(mesh, anchors, at.anchor);
    const anchor = anchors[at.anchor++];
    if (anchor < 0 || anchor >= mesh.vertexCount)
      throw new Damaged("it has a split that cannot be");
    split.anchor = anchor;
    split.moves = true;
    split.newVertices = 1;
    split.byFar = false;
    split.moved = 0;
    split.restored = 0;
    ring.find(mesh, anchor);
    let left = noVertex, right = noVertex;
    if (kind < noSideByBits) {
      this.takeWalk(split);
      const { walked, walkedCount } = ring;
      if (kind !== rightSide) left = ring.b[walked[walkedCount - 1]];
      if (kind !== leftSide) right = ring.a[walked[0]];
    } else {
      ring.sort();
      this.takeBits(split);
      ring.findNear();
      if (kind === bothSidesByBits || kind === leftSideByBits) left = this.takeNeighbour();
      if (kind === bothSidesByBits || kind === rightSideByBits) right = this.takeNeighbour();
    }
    const added = mesh.vertexCount;
    if (left !== noVertex) restore(split, anchor, added, left);
    if (right !== noVertex) restore(split, added, anchor, right);
  }

  // Faces side by side.
  takeWalk(split) {
    const { at, ring } = this;
    const { rings } = this.chunk;
    if (at.ring >= rings.length) throw new Damaged("it ends within a split");
    const first = rings[at.ring++];
    const count = this.takeCount();
    if (first >= ring.count || count === 0 || count > ring.count)
      throw new Damaged("it has a split that cannot be");
    ring.walk(first, count);
    if (ring.walkedCount < count) throw new Damaged("it has a split that cannot be");
    for (let i = 0; i < count; ++i) split.corners[i] = ring.corner[ring.walked[i]];
    split.moved = count;
  }

  takeBits(split) {
    const { ring } = this;
    let bits = 0;
    for (let i = 0; i < ring.count; ++i) {
      if (i % 8 === 0) bits = this.takeCount();
      if (bits & (1 << (i % 8))) split.corners[split.moved++] = ring.corner[i];
    }
  }

  takeCount() {
    const { counts } = this.chunk;
    if (this.at.count >= counts.length) throw new Damaged("it ends within a split");
    return counts[this.at.count++];
  }

  takeNeighbour() {
    const { rings } = this.chunk;
    const { at, ring } = this;
    if (at.ring >= rings.length || rings[at.ring] >= ring.nearCount)
      throw new Damaged("it has a split that cannot be");
    return ring.near[rings[at.ring++]];
  }

  readOneByOne(mesh, kind, split) {
    const { varints } = this.chunk;
    const { varint } = this;
    varint.at = this.at.varint;
    split.moves = kind === oneByOneThatMoves;
    split.anchor = takeVarint(varints, varint) - 1;
    split.newVertices = takeVarint(varints, varint);
    split.moved = takeVarint(varints, varint);
    split.restored = takeVarint(varints, varint);
    split.byFar = true;
    if (2 * split.moved + 3 * split.restored > varints.length - varint.at ||
        split.newVertices > this.chunk.rows)
      throw new Damaged("it ends within a split");
    split.reserve(0, split.moved, split.restored);
    let last = mesh.vertexCount;
    const take = (into, count) => {
      for (let i = 0; i < count; ++i) {
        const coded = takeVarint(varints, varint) | 0;
        into[i] = last = (last + ((coded >>> 1) ^ -(coded & 1))) | 0;
      }
    };
    take(split.far, 2 * split.moved);
    take(split.faces, 3 * split.restored);
    this.at.varint = varint.at;
  }

  readWords(mesh, split) {
    const { differences, rows } = this.chunk;
    const { width } = mesh;
    const count = split.newVertices + (split.moves ? 1 : 0);
    if (count > rows - this.at.row || (split.moves && split.anchor === noVertex))
      throw new Damaged("it ends within a split");
    split.reserve(count * width, 0, 0);
    const { words } = split;
    const old = split.anchor * width;
    const end = count * width;
    let from = this.at.row * width, to = 0;
    this.at.row += count;
    if (split.moves) {
      for (; to < width; ++to) words[to] = (mesh.words[old + to] + differences[from++]) | 0;
      // As far on the other side.
      for (let k = 0; k < width && to < end; ++k, ++to)
        words[to] = ((mesh.words[old + k] << 1) - words[k] + differences[from++]) | 0;
    }
    for (; to < end; ++to)
      words[to] = ((to < width ? 0 : words[to - width]) + differences[from++]) | 0;
  }
}

// The third corner is a neighbour of the anchor.
function restore(split, a, b, c) {
  const at = 3 * split.restored++;
  split.faces[at] = a;
  split.faces[at + 1] = b;
  split.faces[at + 2] = c;
}
