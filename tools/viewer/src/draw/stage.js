// What is seen: one canvas, one camera, and one mesh or two side by side.
import * as three from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const background = 0x1d2126;

export class Stage {
  // `changed` is called when the camera has moved.
  constructor(canvas, changed) {
    three.ColorManagement.enabled = false;  // colours of the file are shown as they are
    this.canvas = canvas;
    this.changed = changed;
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true });
    this.renderer.outputColorSpace = three.LinearSRGBColorSpace;
    this.renderer.setClearColor(background);
    this.renderer.sortObjects = false;  // it would ask for a ball around all that may be shown
    this.camera = new three.PerspectiveCamera(35, 1, 0.01, 100);
    const light = new three.DirectionalLight(0xffffff, 2.8);
    light.position.set(-1, 1.1, 0.7);
    this.camera.add(light, light.target);
    this.scenes = [];
    this.size = "";  // of the canvas, when it got its buffer
    this.up = "y";
    this.radius = 1;
    this.controls = null;
    this.setUp("y");
  }

  // The groups that are shown, from left to right.
  show(groups) {
    this.scenes = groups.map((group) => {
      const scene = new three.Scene();
      scene.add(group, new three.AmbientLight(0xffffff, 0.7));
      return scene;
    });
  }

  setUp(axis) {
    this.up = axis;
    this.camera.up.set(axis === "x" ? 1 : 0, axis === "y" ? 1 : 0, axis === "z" ? 1 : 0);
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", this.changed);
    this.fit(this.radius);
  }

  // A ball around the origin fills the picture.
  fit(radius) {
    this.radius = radius;
    const { camera, controls } = this;
    this.resize();
    const narrow = Math.min(1, camera.aspect);
    const distance = radius / Math.sin(three.MathUtils.degToRad(camera.fov / 2)) / narrow;
    const forward = { x: [0.3, 1, 0.45], y: [0.45, 0.3, 1], z: [0.45, -1, 0.3] }[this.up];
    camera.position.set(...forward).setLength(distance);
    camera.near = distance / 1000;
    camera.far = distance * 10;
    camera.updateProjectionMatrix();
    controls.target.set(0, 0, 0);
    controls.maxDistance = distance * 8;
    controls.update();
    this.changed();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const size = [width, height, devicePixelRatio].join();
    if (size !== this.size) {  // a new buffer takes time
      this.size = size;
      this.renderer.setPixelRatio(devicePixelRatio);
      this.renderer.setSize(width, height, false);
    }
    this.camera.aspect = width / Math.max(this.scenes.length, 1) / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  draw() {
    const { renderer, camera, scenes } = this;
    const { clientWidth, clientHeight: height } = this.canvas;
    const width = clientWidth / Math.max(scenes.length, 1);
    renderer.setScissorTest(true);
    scenes.forEach((scene, i) => {
      renderer.setViewport(i * width, 0, width, height);
      renderer.setScissor(i * width, 0, width, height);
      scene.add(camera);
      renderer.render(scene, camera);
    });
  }
}
