// What is on the page beside the picture: reads what is set there, and shows how things stand.
import { blobOf, download } from "../save/save.js";
import { ProgressiveFile } from "../file/progressive_file.js";
import { FileSource } from "../file/sources.js";
import { facesAt, stepOf } from "./scale.js";

const element = (id) => document.getElementById(id);
const grouped = (number) => number.toLocaleString("en");
const mebibytes = (bytes) => `${(bytes / 2 ** 20).toFixed(1)} MiB`;
const styles = ["flat", "smooth", "wireframe"];

// In the units of the mesh, and as a part of its diagonal.
function errorText(error, diagonal) {
  if (!Number.isFinite(error)) return "unknown";
  const digits = (number) => String(Number(number.toPrecision(3)));
  return `${digits(error)} (${digits(100 * error / diagonal)} %)`;
}

export class Controls {
  constructor(unpacker) {
    this.unpacker = unpacker;
    this.viewer = null;
    this.beside = false;  // where a chosen file goes
  }

  bind(viewer) {
    this.viewer = viewer;
    const on = (id, event, run) => element(id).addEventListener(event, run);
    on("slider", "input", () => this.slide(Number(element("slider").value)));
    on("count", "change", () => this.goToCount(element("count").value));
    on("collapse", "click", () => this.step(false));
    on("rebuild", "click", () => this.step(true));
    on("styles", "change", () => this.look());
    on("colors", "change", () => this.look());
    on("live", "change", () => {
      viewer.normalsWhileSliding = element("live").checked;
      viewer.invalidate();
    });
    on("normals", "click", () => viewer.recomputeNormals());
    on("fit", "click", () => viewer.fit());
    on("up", "change", () => viewer.stage.setUp(element("up").value));
    on("save", "click", () => this.save());
    on("open", "click", () => this.choose(false));
    on("choose", "click", () => this.choose(false));
    on("beside", "click", () => this.choose(true));
    on("alone", "click", () => {
      viewer.closeSecond();
      this.opened();
    });
    on("file", "change", () => this.open(new FileSource(element("file").files[0]), this.beside));
    this.bindDrop();
    addEventListener("keydown", (event) => this.key(event));
  }

  bindDrop() {
    addEventListener("dragover", (event) => event.preventDefault());
    addEventListener("drop", (event) => {
      event.preventDefault();
      const [file] = event.dataTransfer.files;
      // With Shift: beside the one that is open.
      if (file) this.open(new FileSource(file), event.shiftKey);
    });
  }

  key(event) {
    const { target } = event;
    if (event.ctrlKey || event.metaKey || event.altKey || target.type === "text") return;
    const check = (box) => { box.checked = !box.checked; };
    const keys = {
      ArrowLeft: () => this.slide(Number(element("slider").value) - 1),
      ArrowRight: () => this.slide(Number(element("slider").value) + 1),
      c: () => this.step(false),
      r: () => this.step(true),
      1: () => this.setStyle(0),
      2: () => this.setStyle(1),
      3: () => this.setStyle(2),
      n: () => this.viewer.recomputeNormals(),
      v: () => {
        check(element("colors"));
        this.look();
      },
      f: () => this.viewer.fit(),
      u: () => {
        const up = element("up");
        up.selectedIndex = (up.selectedIndex + 1) % 3;
        this.viewer.stage.setUp(up.value);
      },
      s: () => this.save()
    };
    if (!Object.hasOwn(keys, event.key)) return;
    if (event.key.startsWith("Arrow") && target.tagName === "SELECT") return;
    event.preventDefault();
    keys[event.key]();
  }

  async open(source, beside, file = ProgressiveFile.open(source, this.unpacker)) {
    try {
      await this.viewer.open(file, beside);
      this.say("");
      this.opened();
    } catch (error) {
      this.say(`'${source.name}' cannot be shown: ${error.message}`);
    }
  }

  opened() {
    const { views } = this.viewer;
    element("name").textContent = views.map((view) => view.name).join(" | ");
    document.title = `${element("name").textContent} – winnow`;
    element("hint").hidden = true;
    element("alone").hidden = views.length < 2;
    element("of").textContent = `of ${grouped(views[0].full)}`;
    element("colors").disabled = !views.some((view) => view.file.words.hasColors);
    this.viewer.invalidate();
  }

  choose(beside) {
    this.beside = beside;
    element("file").value = "";
    element("file").click();
  }

  slide(step) {
    const [view] = this.viewer.views;
    if (!view) return;
    const bounded = Math.min(Math.max(step, 0), 1000);
    element("slider").value = bounded;
    this.viewer.goTo(facesAt(bounded, view.smallest, view.full));
  }

  goToCount(text) {
    const faces = Number(text.replace(/[,_\s]/g, ""));
    const [view] = this.viewer.views;
    if (!view) return;
    if (text.trim() === "" || !Number.isFinite(faces)) {
      this.say(`'${text}' is no count of faces`);
      return;
    }
    this.say("");
    this.viewer.goTo(faces);
    element("slider").value = stepOf(view.target, view.smallest, view.full);
  }

  async step(forward) {
    if (this.viewer.views.length === 0) return;
    element("step").textContent = await this.viewer.step(forward);
  }

  setStyle(number) {
    document.querySelector(`[name=style][value=${styles[number]}]`).checked = true;
    this.look();
  }

  look() {
    const style = document.querySelector("[name=style]:checked").value;
    this.viewer.setLook(style, element("colors").checked);
  }

  save() {
    const [view] = this.viewer.views;
    if (!view) return;
    const format = element("format").value;
    const name = `${view.name.replace(/\.[^.]*$/, "")}-${view.faces}.${format}`;
    download(blobOf(view.player.mesh, view.file.words, format), name);
  }

  say(text) {
    element("message").textContent = text;
    element("message").hidden = text === "";
  }

  // After each frame.
  show() {
    const { views } = this.viewer;
    if (views.length === 0) return;
    const [view] = views;
    if (document.activeElement !== element("count")) element("count").value = grouped(view.faces);
    if (document.activeElement !== element("slider"))
      element("slider").value = stepOf(view.target, view.smallest, view.full);
    const each = (number) => views.map(number).join(" | ");
    const rate = this.viewer.framesPerSecond();
    const rows = [
      ["faces", each(({ faces }) => grouped(faces))],
      ["vertices", each(({ player }) => grouped(player.mesh.vertexCount))],
      ["edges to collapse", each(({ player }) => grouped(player.log.count))],
      ["edges to rebuild", each(({ player }) => grouped(player.splitsLeft))],
      ["cost", each(({ file }) => file.header.cost)],
      ["error so far", each(({ error, radius }) => errorText(error, 2 * radius))],
      ["loaded", each(({ file }) => mebibytes(file.bytesRead))],
      ["of", each(({ file }) => mebibytes(file.header.full.bytes))],
      ["frames a second", rate ? rate.toFixed(0) : "–"]
    ];
    element("statistics").replaceChildren(...rows.map((row) => {
      const line = document.createElement("tr");
      line.append(...row.map((text) => {
        const cell = document.createElement("td");
        cell.textContent = text;
        return cell;
      }));
      return line;
    }));
    const stopped = views.find(({ player }) => player.problem);
    if (stopped) this.say(`'${stopped.name}': ${stopped.player.problem.message}`);
  }
}
