// Asks Khronos' validator about GLBs: node validate.mjs FILE...; ends with 1 at the first error or warning.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

const { validateBytes } = createRequire(import.meta.url)("gltf-validator");

let failed = false;
for (const name of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(await readFile(name)), { uri: name });
  const { numErrors, numWarnings, messages } = report.issues;
  if (numErrors + numWarnings === 0) continue;
  failed = true;
  console.log(`${name}: ${numErrors} errors, ${numWarnings} warnings`);
  for (const message of messages.filter((one) => one.severity < 2).slice(0, 10))
    console.log(`  ${message.code} ${message.pointer ?? ""}: ${message.message}`);
}
process.exit(failed ? 1 : 0);
