// Makes one page of all that the viewer is, and a source of C++ that holds it.
//   node bundle.mjs PAGE.html [PAGE.cpp]
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "esbuild";

const here = import.meta.dirname;
const script = (await bundled("src/main.js", {
  UNPACK_WORKER: JSON.stringify(await bundled("src/unpack_worker.js", {}))
})).replaceAll("</script", "<\\/script");
const style = readFileSync(join(here, "style.css"), "utf8");
const page = Buffer.from(readFileSync(join(here, "index.html"), "utf8")
  .replace("<!--style-->", () => `<style>\n${style}</style>`)
  .replace("<!--script-->", () => `<script>${script}</script>`));
writeFileSync(process.argv[2], page);
if (process.argv[3]) writeFileSync(process.argv[3], sourceOf(page));

// All that a module imports as one text. `define`: what names in it stand for.
async function bundled(entry, define) {
  const { outputFiles } = await build({
    entryPoints: [join(here, entry)],
    absWorkingDir: here,
    bundle: true,
    minify: true,
    write: false,
    target: "es2022",
    legalComments: "inline",
    define
  });
  return outputFiles[0].text;
}

// As texts that the compiler joins.
function sourceOf(bytes) {
  const lines = ['#include "viewer/page.hpp"', "namespace winnow::viewer {",
    "std::string_view page() {", "  static constexpr char text[] ="];
  for (let at = 0; at < bytes.length; at += 4096) {
    const octal = Array.from(bytes.subarray(at, at + 4096), (byte) =>
      byte >= 0x20 && byte < 0x7f && byte !== 0x22 && byte !== 0x5c && byte !== 0x3f
        ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, "0")}`);
    lines.push(`"${octal.join("")}"`);
  }
  return [...lines, "  ;", "  return {text, sizeof text - 1};", "}",
    "}  // namespace winnow::viewer", ""].join("\n");
}
