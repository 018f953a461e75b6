// Normals of vertices: sums of the normals of their faces by area, as 16-bit numbers.
import { after, before } from "../mesh/split_mesh.js";

const full = 32767;

export class Normals {
  constructor() {
    this.sum = [0, 0, 0];
  }

  // Of all vertices, in the order of faces: the same mesh gets the same normals however it came.
  ofAll(mesh, positions, out) {
    const sums = new Float32Array(3 * mesh.vertexCount);
    const { faces, faceCount } = mesh;
    for (let f = 0, at = 0; f < faceCount; ++f, at += 9) {
      this.sum.fill(0);
      this.add(positions, faces[at], faces[at + 1], faces[at + 2]);
      for (let i = 0; i < 3; ++i) {
        const v = 3 * faces[at + i];
        for (let k = 0; k < 3; ++k) sums[v + k] += this.sum[k];
      }
    }
    for (let v = 0; v < mesh.vertexCount; ++v)
      put(out, v, sums[3 * v], sums[3 * v + 1], sums[3 * v + 2]);
  }

  // Of one vertex, by the faces around it.
  ofVertex(mesh, positions, out, v) {
    const { sum } = this;
    sum.fill(0);
    for (let c = mesh.first[v]; c !== -1; c = mesh.nextCorner(c))
      this.add(positions, mesh.faces[c], mesh.faces[after(c)], mesh.faces[before(c)]);
    put(out, v, sum[0], sum[1], sum[2]);
  }

  add(p, a, b, c) {
    const x = p[3 * a], y = p[3 * a + 1], z = p[3 * a + 2];
    const ux = p[3 * b] - x, uy = p[3 * b + 1] - y, uz = p[3 * b + 2] - z;
    const wx = p[3 * c] - x, wy = p[3 * c + 1] - y, wz = p[3 * c + 2] - z;
    this.sum[0] += uy * wz - uz * wy;
    this.sum[1] += uz * wx - ux * wz;
    this.sum[2] += ux * wy - uy * wx;
  }
}

function put(out, v, x, y, z) {
  const length = Math.sqrt(x * x + y * y + z * z);
  const scale = length > 0 ? full / length : 0;
  out[4 * v] = Math.round(x * scale);
  out[4 * v + 1] = Math.round(y * scale);
  out[4 * v + 2] = Math.round(z * scale);
}
