// The meshes that are open and the loop that draws them. It knows nothing of the page's controls.
import { Stage } from "../draw/stage.js";
import { View } from "./view.js";

// Of a frame, for playing: half of what frames take where drawing is slow.
const leastPlaying = 12, mostPlaying = 250;

export class Viewer {
  // `told` is called after each frame.
  constructor(canvas, told) {
    this.told = told;
    this.views = [];
    this.style = "flat";
    this.colored = true;
    this.normalsWhileSliding = true;
    this.recompute = false;  // all normals, in the next frame
    this.waiting = 0;  // for a frame: a number of the browser
    this.firstPicture = null;  // when it was drawn, in milliseconds
    this.frames = [];  // when the last ones were drawn
    this.stage = new Stage(canvas, () => this.invalidate());
    new ResizeObserver(() => {
      this.stage.resize();
      this.invalidate();
    }).observe(canvas);
  }

  // Shows a file, once it is open, alone or beside the first one.
  async open(opening, beside) {
    const second = beside && this.views.length > 0;
    const view = await View.open(opening, second ? this.views[0].center : undefined);
    for (const old of this.views.splice(second ? 1 : 0)) old.surface.dispose();
    if (second) view.goTo(this.views[0].target);
    this.views.push(view);
    this.shown();
    if (!second) this.fit();
    return view;
  }

  closeSecond() {
    for (const old of this.views.splice(1)) old.surface.dispose();
    this.shown();
  }

  shown() {
    this.stage.show(this.views.map((view) => view.surface.group));
    this.stage.resize();
    this.setLook(this.style, this.colored);
  }

  setLook(style, colored) {
    this.style = style;
    this.colored = colored;
    for (const view of this.views) view.surface.setLook(style, colored);
    this.invalidate();
  }

  goTo(faces) {
    for (const view of this.views) view.goTo(faces);
    this.invalidate();
  }

  async step(forward) {
    const texts = await Promise.all(this.views.map((view) => view.step(forward)));
    this.invalidate();
    return texts.join(" ");
  }

  fit() {
    this.stage.fit(Math.max(...this.views.map((view) => view.radius)));
  }

  recomputeNormals() {
    this.recompute = true;
    this.invalidate();
  }

  // Draws again soon.
  invalidate() {
    this.waiting ||= requestAnimationFrame(() => this.frame());
  }

  frame() {
    this.waiting = 0;
    const now = performance.now();
    const taken = now - (this.frames.at(-1) ?? now);
    const playing = Math.min(Math.max(taken / 2, leastPlaying), mostPlaying);
    const deadline = now + playing / Math.max(this.views.length, 1);
    for (const view of this.views) {
      // The coarsest mesh is the first picture.
      if (this.firstPicture === null) this.invalidate();
      else if (!view.rests) this.play(view, deadline);
      view.surface.update(this.normalsOf(view));
    }
    this.recompute = false;
    this.stage.draw();
    if (this.views.length > 0) this.firstPicture ??= performance.now();
    this.frames = this.frames.slice(-30);
    this.frames.push(performance.now());
    this.told();
  }

  play(view, deadline) {
    const state = view.advance(deadline);
    if (state === "waits") view.file.fetch(view.player.chunk).then(() => this.invalidate());
    else if (!view.rests) this.invalidate();
  }

  // At rest all normals are those of the mesh, so that a picture hangs on its count alone.
  normalsOf(view) {
    if (this.recompute) return "all";
    if (!this.normalsWhileSliding) return "none";
    return view.rests ? "all" : "moved";
  }

  // Resolves when all meshes are where they were sent, and drawn.
  async settled() {
    while (this.waiting || this.views.some((view) => !view.rests))
      await new Promise((resume) => setTimeout(resume, 5));
  }

  framesPerSecond() {
    const recent = this.frames.filter((time) => performance.now() - time < 1000);
    if (recent.length < 2) return null;
    return 1000 * (recent.length - 1) / (recent.at(-1) - recent[0]);
  }
}
