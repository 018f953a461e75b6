// The faces around a vertex. A file counts them in the order of their other corners.
import { Damaged } from "../file/damaged.js";
import { after, before } from "./split_mesh.js";

const mostFaces = 128;
const fetchedFaces = 6;
export const fetchedAtOnce = 32;

export class Ring {
  constructor() {
    this.count = 0;
    this.a = new Int32Array(mostFaces);  // the corner behind the vertex, in the winding
    this.b = new Int32Array(mostFaces);  // the one behind that
    this.corner = new Int32Array(mostFaces);  // at the vertex
    this.near = new Int32Array(2 * mostFaces);  // all these corners, in ascending order
    this.nearCount = 0;
    this.walked = new Int32Array(mostFaces);  // places in the ring
    this.walkedCount = 0;
    this.used = 0;  // of what was fetched, so that nothing is left out
    this.fetched = new Int32Array(fetchedAtOnce);
  }

  // In any order.
  find(mesh, v) {
    const { faces } = mesh;
    const { a, b, corner } = this;
    let count = 0;
    for (let at = mesh.first[v]; at !== -1; at = mesh.nextCorner(at), ++count) {
      if (count === mostFaces) throw new Damaged("it has a split that cannot be");
      a[count] = faces[after(at)];
      b[count] = faces[before(at)];
      corner[count] = at;
    }
    this.count = count;
  }

  sort() {
    const { a, b, corner } = this;
    for (let end = 1; end < this.count; ++end) {
      const p = a[end], q = b[end], at = corner[end];
      let i = end;
      for (; i > 0; --i) {
        const smaller = a[i - 1] !== p ? a[i - 1] < p
          : b[i - 1] !== q ? b[i - 1] < q : corner[i - 1] < at;
        if (smaller) break;
        a[i] = a[i - 1];
        b[i] = b[i - 1];
        corner[i] = corner[i - 1];
      }
      a[i] = p;
      b[i] = q;
      corner[i] = at;
    }
  }

  // Where the face is that so many come before. To count them takes no order, and nothing that a
  // processor would guess wrong.
  ranked(rank) {
    const { a, count } = this;
    for (let i = 0; i < count; ++i) {
      const p = a[i];
      let smaller = 0;
      for (let k = 0; k < count; ++k) smaller += (a[k] - p) >>> 31;
      if (smaller !== rank) continue;
      if (this.only(p) !== i) break;
      return i;
    }
    this.sort();
    return rank;
  }

  // Where the one face is that begins with `p`; -1 where not one does.
  only(p) {
    const { a, count } = this;
    let found = -1;
    for (let i = 0; i < count; ++i) {
      if (a[i] !== p) continue;
      if (found !== -1) return -1;
      found = i;
    }
    return found;
  }

  findNear() {
    const { a, b, near } = this;
    let count = 0;
    for (let i = 0; i < this.count; ++i) {
      if (count === 0 || near[count - 1] !== a[i]) near[count++] = a[i];
    }
    for (let i = 0; i < this.count; ++i) {
      const v = b[i];
      let at = count;
      while (at > 0 && near[at - 1] > v) --at;
      if (at > 0 && near[at - 1] === v) continue;
      for (let k = count++; k > at; --k) near[k] = near[k - 1];
      near[at] = v;
    }
    this.nearCount = count;
  }

  // So many faces side by side, the first at a rank; fewer where not one face is next.
  walk(rank, most) {
    const { b, walked } = this;
    let steps = 0;
    for (let at = this.ranked(rank); at !== -1; at = this.only(b[at])) {
      for (let k = 0; k < steps; ++k) {
        if (walked[k] === at) throw new Damaged("it has a split that cannot be");
      }
      walked[steps++] = at;
      if (steps === most) break;
    }
    this.walkedCount = steps;
  }

  // Walks around the next vertices from `begin` on side by side, so that the processor fetches many
  // faces at a time: one walk alone waits for each.
  fetch(mesh, vertices, begin) {
    const { fetched } = this;
    let count = 0, used = 0;
    const end = Math.min(begin + fetchedAtOnce, vertices.length);
    for (let i = begin; i < end; ++i) {
      const v = vertices[i];
      if (v < 0 || v >= mesh.vertexCount) continue;
      fetched[count++] = mesh.first[v];
      used ^= mesh.words[mesh.width * v];
    }
    for (let step = 0; step < fetchedFaces; ++step) {
      for (let i = 0; i < count; ++i) {
        const corner = fetched[i];
        if (corner === -1) continue;
        fetched[i] = mesh.nextCorner(corner);
        used ^= mesh.touchFace(corner);
      }
    }
    this.used = used;
  }
}
