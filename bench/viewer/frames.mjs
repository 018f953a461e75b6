// Moves the slider of the page down and up in a headless Chromium. It has no graphics card, which
// would draw millions of faces: what a frame changes is sent, and one face of it is drawn.
//   node frames.mjs WINNOW CHROMIUM FILE
import { Page, launch, serve } from "../../tests/viewer/browser.mjs";

const [, , winnow, chromium, name] = process.argv;
const browser = await launch(chromium);
const server = await serve(winnow, name);
const page = await Page.open(browser, server.address);
await page.page.waitForFunction(() => globalThis.viewer.firstPicture !== null);
const firstPicture = await page.page.evaluate(() => globalThis.viewer.firstPicture);
await page.page.evaluate(() => {
  const Geometry = globalThis.viewer.views[0].surface.solid.geometry.constructor;
  Geometry.prototype.setDrawRange = function setDrawRange() {
    this.drawRange = { start: 0, count: 3 };
  };
});
await page.shown();
const frames = await page.page.evaluate(async () => {
  const { viewer } = globalThis;
  const [view] = viewer.views;
  const milliseconds = 6000;
  const work = [];
  const frame = viewer.frame.bind(viewer);
  viewer.frame = () => {
    const from = performance.now();
    frame();
    work.push(performance.now() - from);
  };
  const begin = performance.now();
  for (let time = 0; time < milliseconds; time = performance.now() - begin) {
    const share = Math.abs(1 - 2 * time / milliseconds);  // down and up
    viewer.goTo(view.full * (view.smallest / view.full) ** (1 - share));
    await new Promise((resume) => requestAnimationFrame(resume));
  }
  const seconds = (performance.now() - begin) / 1000;
  work.sort((a, b) => a - b);
  return { drawn: work.length / seconds, work: work[work.length >> 1],
    longest: work[Math.floor(work.length * 0.95)] };
});
console.log(JSON.stringify({ firstPicture, ...frames }));
await browser.close();
await server.end();
