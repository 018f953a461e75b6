// A split mesh as three.js draws it. Only what has changed goes to the graphics card.
import * as three from "three";
import { Normals } from "./normals.js";

export const styles = ["flat", "smooth", "wireframe"];
const gray = 0xb9bec6;

export class Surface {
  // Draws around `center`: floats are too coarse for what lies far away.
  constructor(mesh, words, center) {
    this.mesh = mesh;
    this.words = words;
    this.center = center;
    this.normals = new Normals();
    this.normalsWait = true;  // those of all are out of date
    this.style = "flat";
    this.colored = false;
    this.group = new three.Group();
    this.solid = new three.Mesh(new three.BufferGeometry());
    this.lines = new three.LineSegments(new three.BufferGeometry());
    for (const object of [this.solid, this.lines]) object.frustumCulled = false;
    this.group.add(this.solid, this.lines);
    this.setLook("flat", false);
  }

  setLook(style, colored) {
    this.style = style;
    this.colored = colored && this.words.hasColors;
    const wire = style === "wireframe";
    const color = this.colored ? 0xffffff : gray;
    const look = { color, vertexColors: this.colored, side: three.DoubleSide };
    this.solid.material.dispose();
    this.solid.material = wire
      // What is behind the surface is hidden.
      ? new three.MeshBasicMaterial({ color: 0x1d2126, side: three.DoubleSide, polygonOffset: true,
        polygonOffsetFactor: 1, polygonOffsetUnits: 1 })
      : new three.MeshLambertMaterial({ ...look, flatShading: style === "flat" });
    this.lines.material.dispose();
    this.lines.material = new three.LineBasicMaterial({ color, vertexColors: this.colored });
    this.lines.visible = wire;
    if (wire) this.linesWait = true;
    if (style === "smooth") this.normalsWait = true;
  }

  // Brings what is drawn up to the mesh. `normals`: "all" of them, those of vertices that "moved",
  // or "none".
  update(normals) {
    const { mesh } = this;
    this.makeRoom();
    const geometry = this.solid.geometry;
    const { position, index } = this.arrays;
    const smooth = this.style === "smooth";
    const moved = smooth && normals === "moved";
    if (mesh.changedVertices.any() || mesh.changedFaces.any()) this.normalsWait = true;
    mesh.changedVertices.take(mesh.vertexCount, (v) => this.putVertex(v, moved), (begin, end) => {
      changed(position, begin, end);
      if (this.arrays.color) changed(this.arrays.color, begin, end);
      if (moved) changed(this.arrays.normal, begin, end);
    });
    const lined = this.style === "wireframe" && !this.linesWait;
    if (!lined) this.linesWait = true;
    mesh.changedFaces.take(mesh.faceCount, (f) => this.putFace(f, lined), (begin, end) => {
      changed(index, 3 * begin, 3 * end);
      if (lined) changed(this.arrays.lines, 6 * begin, 6 * end);
    });
    if (smooth && normals === "all" && this.normalsWait) {
      this.normals.ofAll(mesh, position.array, this.arrays.normal.array);
      changed(this.arrays.normal, 0, mesh.vertexCount);
      this.normalsWait = false;
    }
    if (this.style === "wireframe" && this.linesWait) {
      this.putAllLines();
      this.linesWait = false;
    }
    geometry.setDrawRange(0, 3 * mesh.faceCount);
    this.lines.geometry.setDrawRange(0, 6 * mesh.faceCount);
  }

  dispose() {
    for (const object of [this.solid, this.lines]) {
      object.geometry.dispose();
      object.material.dispose();
    }
  }

  // New arrays, larger ones, where the mesh has outgrown them.
  makeRoom() {
    const { mesh } = this;
    const { vertexRoom: vertices, faceRoom: faces } = mesh;
    if (this.arrays && this.arrays.vertices === vertices && this.arrays.faces === faces) return;
    for (const object of [this.solid, this.lines]) {
      object.geometry.dispose();
      object.geometry = new three.BufferGeometry();
    }
    const attribute = (Type, size, count, normalized) => {
      const made = new three.BufferAttribute(new Type(size * count), size, normalized);
      made.setUsage(three.DynamicDrawUsage);
      return made;
    };
    this.arrays = {
      vertices,
      faces,
      position: attribute(Float32Array, 3, vertices, false),
      normal: attribute(Int16Array, 4, vertices, true),
      color: this.words.hasColors ? attribute(Uint8Array, 4, vertices, true) : null,
      index: attribute(Uint32Array, 1, 3 * faces, false),
      lines: null
    };
    const { geometry } = this.solid;
    geometry.setIndex(this.arrays.index);
    for (const name of ["position", "normal", "color"]) {
      if (!this.arrays[name]) continue;
      geometry.setAttribute(name, this.arrays[name]);
      if (name !== "normal") this.lines.geometry.setAttribute(name, this.arrays[name]);
    }
    mesh.changedVertices.markAll();
    mesh.changedFaces.markAll();
    this.linesWait = true;
    this.normalsWait = true;
  }

  // A vertex in the arrays; its normal by the places that its neighbours have by now.
  putVertex(v, withNormal) {
    const { mesh, words, center, arrays } = this;
    const position = arrays.position.array;
    const at = words.width * v;
    for (let axis = 0; axis < 3; ++axis)
      position[3 * v + axis] = words.coordinate(mesh.words, at, axis) - center[axis];
    if (arrays.color) {
      const color = arrays.color.array;
      for (let k = 0; k < 3; ++k) color[4 * v + k] = words.colorByte(mesh.words, at, k);
      color[4 * v + 3] = 255;
    }
    if (withNormal) this.normals.ofVertex(mesh, position, arrays.normal.array, v);
  }

  putFace(f, withLines) {
    const { faces } = this.mesh;
    const index = this.arrays.index.array;
    index[3 * f] = faces[9 * f];
    index[3 * f + 1] = faces[9 * f + 1];
    index[3 * f + 2] = faces[9 * f + 2];
    if (withLines) this.putLines(f);
  }

  putAllLines() {
    if (!this.arrays.lines) {
      const lines = new three.BufferAttribute(new Uint32Array(6 * this.arrays.faces), 1);
      this.arrays.lines = lines.setUsage(three.DynamicDrawUsage);
      this.lines.geometry.setIndex(lines);
    }
    for (let f = 0; f < this.mesh.faceCount; ++f) this.putLines(f);
    changed(this.arrays.lines, 0, 6 * this.mesh.faceCount);
  }

  putLines(f) {
    const { faces } = this.mesh;
    const lines = this.arrays.lines.array;
    for (let i = 0; i < 3; ++i) {
      lines[6 * f + 2 * i] = faces[9 * f + i];
      lines[6 * f + 2 * i + 1] = faces[9 * f + (i + 1) % 3];
    }
  }
}

// These items of an array go to the graphics card.
function changed(attribute, begin, end) {
  attribute.addUpdateRange(attribute.itemSize * begin, attribute.itemSize * (end - begin));
  attribute.needsUpdate = true;
}
