// A headless Chromium with the page of `winnow view` in it.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";
import { chromium } from "../../tools/viewer/node_modules/playwright-core/index.mjs";

// Without a graphics card: the processor draws.
const drawing = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader"];

export function launch(executablePath) {
  return chromium.launch({ executablePath, args: drawing });
}

// Runs `winnow view`; gives its address and how to end it.
export async function serve(winnow, ...inputs) {
  const server = spawn(winnow, ["view", ...inputs, "--no-browser", "--json"],
    { stdio: ["ignore", "pipe", "inherit"] });
  let json = "";
  for await (const line of createInterface({ input: server.stdout })) {
    json += line;
    if (line === "}") break;
  }
  return {
    address: JSON.parse(json).address,
    async end() {
      server.kill("SIGINT");
      const [code] = server.exitCode === null ? await once(server, "exit") : [server.exitCode];
      return code;
    }
  };
}

export class Page {
  static async open(browser, address) {
    const page = await browser.newPage({ viewport: { width: 560, height: 240 } });
    const opened = new Page(page);
    page.on("pageerror", (error) => opened.errors.push(error.message));
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type())) opened.errors.push(message.text());
    });
    await page.goto(address);
    return opened;
  }

  constructor(page) {
    this.page = page;
    this.errors = [];
  }

  async shown(count = 1) {
    await this.page.waitForFunction((wanted) => globalThis.viewer.views.length === wanted ||
      document.querySelector("#message").textContent !== "", count);
    const views = await this.page.evaluate(() => globalThis.viewer.views.length);
    if (views !== count) throw new Error(await this.text("message"));
    await this.settled();
  }

  settled() {
    return this.page.evaluate(() => globalThis.viewer.settled());
  }

  faces() {
    return this.page.evaluate(() => globalThis.viewer.views[0].faces);
  }

  // By the field for an exact count.
  async goTo(count) {
    await this.page.fill("#count", String(count));
    await this.page.press("#count", "Enter");
    await this.settled();
  }

  // The picture, to be compared: drawn again and read at once, as a busy browser shows it late.
  async picture() {
    return Buffer.from(await this.page.evaluate(() => {
      const { stage } = globalThis.viewer;
      stage.draw();
      return stage.canvas.toDataURL();
    }));
  }

  async press(key) {
    await this.page.locator("#canvas").focus();
    await this.page.keyboard.press(key);
    await this.settled();
  }

  statistic(name) {
    return this.page.textContent(`#statistics tr:has(td:text-is("${name}")) td:last-child`);
  }

  text(id) {
    return this.page.textContent(`#${id}`);
  }

  // Saves as a file of this name.
  async save(format, name) {
    await this.page.selectOption("#format", format);
    const saved = this.page.waitForEvent("download");
    await this.page.click("#save");
    await (await saved).saveAs(name);
  }

  close() {
    return this.page.close();
  }
}
