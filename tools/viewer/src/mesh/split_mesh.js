// A mesh that splits are applied to and taken back from.
//
// A corner is 9 f + i: what is known of a face lies together, as walks around vertices jump from
// face to face. faces[corner] is its vertex, faces[corner + 3] the next corner of the same vertex,
// and faces[corner + 6] the one before. What changes is marked for whoever draws it.
import { Damaged } from "../file/damaged.js";
import { Changes } from "./changes.js";
import { grown, roomFor } from "./grown.js";
import { noVertex } from "./split.js";

const none = -1;
const faceInts = 9;
const next = 3, previous = 6;  // behind a corner's vertex
const fewFaces = 3e4, manyFaces = 4e6;

export class SplitMesh {
  // `full`: of what it can become, { vertices, faces }.
  constructor(width, full) {
    this.width = width;
    this.full = full;
    this.vertexCount = 0;
    this.faceCount = 0;
    this.vertexRoom = 0;
    this.faceRoom = 0;
    this.words = new Int32Array(0);
    this.first = new Int32Array(0);
    this.faces = new Int32Array(0);
    this.changedVertices = new Changes();
    this.changedFaces = new Changes();
  }

  reserve(vertices, faces) {
    // Little at first, so that something is seen; then for all, as to grow holds up a frame.
    const { full } = this;
    const all = faces > fewFaces && full.faces <= manyFaces;
    this.vertexRoom = roomFor(all ? Math.max(vertices, full.vertices) : vertices, this.vertexRoom);
    this.faceRoom = roomFor(all ? Math.max(faces, full.faces) : faces, this.faceRoom);
    this.words = grown(this.words, this.width * this.vertexRoom);
    this.first = grown(this.first, this.vertexRoom);
    this.faces = grown(this.faces, faceInts * this.faceRoom);
    this.changedVertices.reserve(this.vertexRoom);
    this.changedFaces.reserve(this.faceRoom);
  }

  // Refuses, and changes nothing, where the split names what is not there.
  apply(split) {
    const first = this.vertexCount;
    const end = first + split.newVertices;
    const { anchor, width } = this.checked(split);
    if (split.byFar) this.findCorners(split);
    const faceEnd = this.faceCount + split.restored;
    if (end > this.vertexRoom || faceEnd > this.faceRoom) this.reserve(end, faceEnd);
    let from = 0;
    if (split.moves) {
      for (let k = 0; k < width; ++k) this.words[width * anchor + k] = split.words[from++];
      this.changedVertices.mark(anchor);
    }
    for (let v = first; v < end; ++v) {
      for (let k = 0; k < width; ++k) this.words[width * v + k] = split.words[from++];
      this.first[v] = none;
      this.changedVertices.mark(v);
    }
    this.vertexCount = end;
    for (let i = 0; i < split.moved; ++i) this.handOver(split.corners[i], anchor, first);
    for (let i = 0; i < split.restored; ++i) {
      const corner = faceInts * this.faceCount;
      this.changedFaces.mark(this.faceCount++);
      for (let k = 0; k < 3; ++k) this.link(corner + k, split.faces[3 * i + k]);
    }
  }

  // Takes the last split back; `before`: the words that the anchor had, from `at` on.
  takeBack(anchor, newVertices, restored, moves, before, at) {
    for (let i = 0; i < restored; ++i) {
      const corner = faceInts * --this.faceCount;
      for (let k = 0; k < 3; ++k) this.unlink(corner + k, this.faces[corner + k]);
    }
    const first = this.vertexCount - newVertices;
    if (anchor !== noVertex && newVertices > 0) {
      while (this.first[first] !== none) this.handOver(this.first[first], first, anchor);
    }
    if (moves) {
      const { width } = this;
      for (let k = 0; k < width; ++k) this.words[width * anchor + k] = before[at + k];
      this.changedVertices.mark(anchor);
    }
    this.vertexCount = first;
  }

  hasFaces(v) {
    return this.first[v] !== none;
  }

  checked(split) {
    const { anchor, newVertices } = split;
    const end = this.vertexCount + newVertices;
    if (anchor < noVertex || anchor >= this.vertexCount ||
        (anchor === noVertex && (split.moves || split.moved > 0)) ||
        (split.moved > 0 && newVertices === 0))
      throw new Damaged("it has a split that cannot be");
    for (let i = 0; i < 3 * split.restored; i += 3) {
      const a = split.faces[i], b = split.faces[i + 1], c = split.faces[i + 2];
      if (a < 0 || b < 0 || c < 0 || a >= end || b >= end || c >= end || a === b || b === c ||
          c === a)
        throw new Damaged("it has a split that cannot be");
    }
    return { anchor, width: this.width };
  }

  // Of equal faces each is taken once.
  findCorners(split) {
    const { anchor } = split;
    for (let i = 0; i < split.moved; ++i) {
      const corner = this.cornerAt(anchor, split.far[2 * i], split.far[2 * i + 1]);
      if (corner !== none) this.unlink(corner, anchor);
      split.corners[i] = corner;
    }
    const found = split.corners.subarray(0, split.moved);
    for (const corner of found) {
      if (corner !== none) this.link(corner, anchor);
    }
    if (found.includes(none)) throw new Damaged("it has a split that cannot be");
  }

  // Looks around the vertex at the far end as well: the anchor may have very many faces.
  cornerAt(v, a, b) {
    if (a < 0 || b < 0 || a >= this.vertexCount || b >= this.vertexCount) return none;
    const { faces } = this;
    let here = this.first[v], there = this.first[a];
    while (here !== none && there !== none) {
      if (faces[after(here)] === a && faces[before(here)] === b) return here;
      if (faces[after(there)] === b && faces[before(there)] === v) return before(there);
      here = faces[here + next];
      there = faces[there + next];
    }
    return none;
  }

  // The corner behind it at the same vertex; -1 where there is none.
  nextCorner(corner) {
    return this.faces[corner + next];
  }

  // Reads both ends of what is known of a face.
  touchFace(corner) {
    return this.faces[corner] ^ this.faces[corner + previous];
  }

  // Corner `i` of face `f`.
  vertexOf(f, i) {
    return this.faces[faceInts * f + i];
  }

  handOver(corner, from, to) {
    this.unlink(corner, from);
    this.link(corner, to);
    this.changedFaces.mark((corner / faceInts) | 0);
  }

  link(corner, v) {
    const { faces } = this;
    const second = this.first[v];
    faces[corner] = v;
    faces[corner + next] = second;
    faces[corner + previous] = none;
    if (second !== none) faces[second + previous] = corner;
    this.first[v] = corner;
  }

  unlink(corner, v) {
    const { faces } = this;
    const behind = faces[corner + next], ahead = faces[corner + previous];
    if (ahead === none) this.first[v] = behind;
    else faces[ahead + next] = behind;
    if (behind !== none) faces[behind + previous] = ahead;
  }
}

// The other corners of the same face.
export function after(corner) {
  return corner % faceInts === 2 ? corner - 2 : corner + 1;
}
export function before(corner) {
  return corner % faceInts === 0 ? corner + 2 : corner - 1;
}
