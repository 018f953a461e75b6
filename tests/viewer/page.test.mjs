// What the page of `winnow view` does, in a real browser.
//   WINNOW=... CHROMIUM=... node --test page.test.mjs     in an empty folder with whale.ply
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, truncateSync, copyFileSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { makeMeshes } from "./meshes.mjs";
import { Page, launch, serve } from "./browser.mjs";
import { facesOf } from "./surface.mjs";

const { WINNOW: winnow, CHROMIUM: chromium } = process.env;
const run = (...words) => execFileSync(winnow, words, { stdio: ["ignore", "pipe", "inherit"] });
// As the file has it: nothing unfolded.
const raw = run("extract", "--help").includes("--raw") ? ["--raw"] : [];
let browser = null;

before(async () => {
  // Few enough for a processor that draws.
  run("simplify", "whale.ply", "-o", "skull.ply", "--faces", "20k", "-q");
  run("progressive", "skull.ply", "-o", "skull.wpm", "-q");
  makeMeshes(run);
  browser = await launch(chromium);
});
after(() => browser?.close());

// Opens `inputs` and lets `check` look at the page, which must not complain.
async function look(inputs, check) {
  const server = await serve(winnow, ...inputs);
  try {
    const page = await Page.open(browser, server.address);
    await check(page, server);
    assert.deepEqual(page.errors, []);
    await page.close();
  } finally {
    assert.equal(await server.end(), 0);
  }
}

test("a slide down and up ends in the same picture", () => look(["skull.wpm"], async (page) => {
  await page.shown();
  assert.equal(await page.faces(), 20000);
  for (const key of ["1", "2"]) {
    await page.press(key);
    await page.goTo(8000);
    const before = await page.picture();
    for (const count of [20000, 1000, 12001, 8000]) await page.goTo(count);
    const after = await page.picture();
    assert.ok(before.equals(after), `style ${key}: the picture has changed`);
    await page.goTo(3000);
    assert.ok(!after.equals(await page.picture()), "another count looks the same");
  }
}));

test("the slider goes by equal ratios, the field to an exact count", () =>
  look(["skull.wpm"], async (page) => {
    await page.shown();
    await page.page.fill("#slider", "500");
    await page.settled();
    assert.ok(Math.abs(await page.faces() - 4472) <= 2);
    await page.page.fill("#slider", "1000");
    await page.settled();
    assert.equal(await page.faces(), 1000);
    await page.goTo("2,346");
    assert.equal(await page.faces(), 2346);
    await page.goTo("many");
    assert.match(await page.text("message"), /'many' is no count of faces/);
    assert.equal(await page.faces(), 2346);
  }));

test("single steps collapse an edge and rebuild it", () => look(["skull.wpm"], async (page) => {
  await page.shown();
  await page.goTo(3000);
  const before = await page.picture();
  await page.page.click("#collapse");
  await page.page.waitForFunction(() => document.querySelector("#step").textContent !== "");
  assert.match(await page.text("step"), /^Collapsed: vertex \d+ went into vertex \d+; 2 faces/);
  await page.settled();
  assert.equal(await page.faces(), 2998);
  await page.press("c");
  assert.equal(await page.faces(), 2996);
  await page.press("r");
  await page.page.click("#rebuild");
  await page.page.waitForFunction(() => globalThis.viewer.views[0].faces === 3000);
  assert.match(await page.text("step"), /^Rebuilt: vertex \d+ was split off vertex \d+/);
  await page.settled();
  await page.page.locator("#canvas").focus();
  assert.ok(before.equals(await page.picture()));
  await page.goTo(1000);
  await page.press("c");
  assert.equal(await page.text("step"), "This is the coarsest mesh.");
}));

test("flat, smooth and wireframe look different", () => look(["skull.wpm"], async (page) => {
  await page.shown();
  await page.goTo(2000);
  const pictures = [];
  for (const key of ["1", "2", "3"]) {
    await page.press(key);
    pictures.push((await page.picture()).toString("base64"));
  }
  assert.equal(new Set(pictures).size, 3);
  await page.press("1");
  assert.equal((await page.picture()).toString("base64"), pictures[0]);
}));

test("colours are shown or not, and any axis can be up", () =>
  look(["colored.ply"], async (page) => {
    await page.shown();
    const seen = new Set();
    for (const key of ["1", "v", "u", "u", "v"]) {
      await page.press(key);
      seen.add((await page.picture()).toString("base64"));
    }
    assert.equal(seen.size, 5);
    await page.press("u");
    assert.equal(await page.page.inputValue("#up"), "y");
    for (const format of ["ply", "glb"]) {
      await page.save(format, `colors.${format}`);
      const { faces } = facesOf(winnow, `colors.${format}`);
      assert.equal(faces.length, 3042);
    }
    const saved = JSON.parse(run("info", "colors.glb", "--json"));
    assert.match(JSON.stringify(saved), /red/);
  }));

test("the error so far is that of 'winnow info'", async () => {
  run("progressive", "skull.ply", "-o", "lattice.wpm", "--bits", "10", "-q", "--force");
  run("progressive", "skull.ply", "-o", "importance.wpm", "--refine", "importance", "-q", "--force");
  const shown = (error) =>
    typeof error === "number" ? String(Number(error.toPrecision(3))) : "unknown";
  for (const name of ["skull.wpm", "lattice.wpm", "importance.wpm"]) {
    const { prefixes } = JSON.parse(run("info", name, "--json"));
    await look([name], async (page) => {
      await page.shown();
      for (const { faces, error } of [prefixes[0], prefixes.at(-1)]) {
        await page.goTo(faces);
        assert.equal((await page.statistic("error so far")).split(" ")[0], shown(error), name);
      }
    });
  }
});

test("a phone's fingers turn, zoom and move the mesh, and reach what is beside it", async () => {
  const server = await serve(winnow, "skull.wpm");
  const context = await browser.newContext({ viewport: { width: 390, height: 664 }, hasTouch: true,
    isMobile: true });
  const page = new Page(await context.newPage());
  await page.page.goto(server.address);
  await page.shown();
  const { width, least } = await page.page.evaluate(() => ({
    width: document.documentElement.scrollWidth,
    least: Math.min(...Array.from(document.querySelectorAll("button, select, #slider, #count"))
      .filter((control) => control.offsetParent).map((control) => control.offsetHeight))
  }));
  assert.equal(width, 390);
  assert.ok(least >= 40, `a control is ${least} high`);
  const fingers = await context.newCDPSession(page.page);
  // From places to others, in steps.
  const drag = async (...ways) => {
    for (let step = 0; step <= 4; ++step) {
      await fingers.send("Input.dispatchTouchEvent", {
        type: step === 0 ? "touchStart" : "touchMove",
        touchPoints: ways.map(([x, y, toX, toY], id) =>
          ({ id, x: x + (toX - x) * step / 4, y: y + (toY - y) * step / 4 }))
      });
    }
    await fingers.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await page.settled();
    return page.page.evaluate(() => {
      const { camera, controls } = globalThis.viewer.stage;
      return { place: camera.position.toArray(), target: controls.target.toArray(),
        distance: camera.position.distanceTo(controls.target) };
    });
  };
  const begin = await drag([100, 100, 100, 100]);
  const turned = await drag([100, 100, 150, 100]);
  assert.notDeepEqual(turned.place, begin.place);
  assert.deepEqual(turned.target, [0, 0, 0]);
  const zoomed = await drag([150, 120, 100, 120], [200, 120, 250, 120]);
  assert.ok(zoomed.distance < 0.6 * begin.distance);
  const moved = await drag([150, 120, 200, 120], [200, 120, 250, 120]);
  assert.ok(Math.hypot(...moved.target) > 0.01 * begin.distance);
  await page.page.tap("#fit");
  await page.settled();
  await page.page.tap("#slider");
  await page.page.waitForFunction(() => globalThis.viewer.views[0].target < 10_000);
  await page.settled();
  assert.ok(Math.abs(await page.faces() - 4472) < 200, String(await page.faces()));
  await context.close();
  await server.end();
});

test("a browser that cannot draw is told so", async () => {
  const server = await serve(winnow, "skull.wpm");
  const page = await browser.newPage();
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(server.address);
  await page.waitForSelector("#message:visible");
  assert.match(await page.textContent("#message"), /WebGL is missing/);
  await page.close();
  await server.end();
});

test("what is saved is what 'winnow extract' gives", () => look(["skull.wpm"], async (page) => {
  await page.shown();
  await page.goTo(5000);
  run("extract", "skull.wpm", "-o", "extracted.ply", "--faces", "5000", ...raw, "--force", "-q");
  const expected = facesOf(winnow, "extracted.ply");
  for (const format of ["ply", "glb", "obj", "m"]) {
    await page.save(format, `saved.${format}`);
    assert.deepEqual(facesOf(winnow, `saved.${format}`), expected, format);
  }
}));

test("no more is loaded than is seen, by ranges", async () => {
  const server = await serve(winnow, "skull.wpm");
  const page = await browser.newPage();
  const ranges = [];
  page.on("request", (request) => {
    if (request.url().includes("skull.wpm") && request.resourceType() === "fetch")
      ranges.push(request.headers().range);
  });
  await page.goto(server.address);
  await page.waitForFunction(() => globalThis.viewer.views[0]?.rests);
  assert.ok(ranges.length >= 2);
  assert.equal(ranges[0], "bytes=0-131071");
  const ends = ranges.map((range) => Number(range.split("-")[1]));
  assert.deepEqual([...ends].sort((a, b) => a - b), ends);
  assert.equal(ends.at(-1), readFileSync("skull.wpm").length - 1);
  await page.close();
  await server.end();
});

test("a file that is cut short shows what is there", async () => {
  copyFileSync("skull.wpm", "cut.wpm");
  truncateSync("cut.wpm", 100_000);
  await look(["cut.wpm"], async (page) => {
    await page.shown();
    const faces = await page.faces();
    assert.ok(faces > 2000 && faces < 15000, String(faces));
    assert.match(await page.text("message"), /it ends after 100000 bytes of \d+/);
    await page.goTo(2000);
    assert.equal(await page.faces(), 2000);
  });
});

test("a damaged file shows what lies before the damage", async () => {
  const bytes = readFileSync("skull.wpm");
  bytes[100_000] ^= 4;
  writeFileSync("damaged.wpm", bytes);
  await look(["damaged.wpm"], async (page) => {
    await page.shown();
    assert.ok(await page.faces() < 15000);
    assert.match(await page.text("message"), /chunk \d+ is damaged: it is not what was written/);
  });
  bytes[20] ^= 1;
  writeFileSync("headless.wpm", bytes);
  assert.throws(() => run("view", "headless.wpm", "--no-browser"), { status: 3 });
});

test("a worker unpacks what comes behind the first picture; without one nothing is amiss",
  async () => {
    const server = await serve(winnow, "skull.wpm");
    for (const missing of [false, true]) {
      const page = new Page(await browser.newPage());
      if (missing) await page.page.addInitScript(() => delete globalThis.Worker);
      await page.page.goto(server.address);
      await page.shown();
      if (!missing)
        await page.page.waitForFunction(() => globalThis.viewer.views[0].file.unpacker.ready);
      const states = await page.page.evaluate(() => {
        const { file } = globalThis.viewer.views[0];
        file.open.clear();  // as if they had been used long ago
        return { ready: file.unpacker.ready, chunk: file.chunk(file.header.baseChunks) === null };
      });
      assert.deepEqual(states, { ready: !missing, chunk: !missing });
      for (const count of [2000, 20000]) {
        await page.goTo(count);
        assert.equal(await page.faces(), count);
      }
      const bytes = readFileSync("skull.wpm");
      bytes[100_000] ^= 4;
      writeFileSync("spoiled.wpm", bytes);
      await page.page.setInputFiles("#file", "spoiled.wpm");
      await page.page.waitForFunction(() => document.title.startsWith("spoiled"));
      await page.settled();
      assert.match(await page.text("message"), /chunk \d+ is damaged: it is not what was written/);
      assert.ok(await page.faces() > 2000 && await page.faces() < 15000);
      await page.close();
    }
    await server.end();
  });

test("two meshes turn together, side by side", () =>
  look(["skull.wpm", "skull.ply"], async (page) => {
    await page.shown(2);
    assert.equal(await page.text("name"), "skull.wpm | skull.ply");
    await page.goTo(2000);
    assert.deepEqual(
      await page.page.evaluate(() => globalThis.viewer.views.map((view) => view.faces)),
      [2000, 2000]);
    const before = await page.picture();
    await page.page.mouse.move(100, 100);
    await page.page.mouse.down();
    await page.page.mouse.move(160, 120);
    await page.page.mouse.up();
    await page.settled();
    assert.ok(!before.equals(await page.picture()));
    await page.press("f");
    assert.ok(before.equals(await page.picture()));
  }));

test("a dropped file is opened", async () => {
  run("view", "skull.wpm", "--export", "page.html", "--force", "-q");
  const page = await Page.open(browser, `file://${process.cwd()}/page.html`);
  await page.shown();
  assert.equal(await page.faces(), 20000);
  await page.page.setInputFiles("#file", "skull.wpm");
  await page.shown();
  assert.equal(await page.text("name"), "skull.wpm");
  const base64 = readFileSync("skull.wpm").toString("base64");
  await page.page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const data = new DataTransfer();
    data.items.add(new File([bytes], "dropped.wpm"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
  }, base64);
  await page.page.waitForFunction(() => document.title.startsWith("dropped.wpm"));
  await page.shown();
  assert.equal(await page.faces(), 20000);
  assert.deepEqual(page.errors, []);
  await page.close();
});
