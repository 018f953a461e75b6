// The worker that unpacks chunks, in a thread of Node.js.
import { Worker, isMainThread, parentPort } from "node:worker_threads";
import { Unpacker, serveUnpacking } from "../../tools/viewer/src/file/unpacker.js";

if (!isMainThread) {
  parentPort.on("message",
    serveUnpacking((message, parts) => parentPort.postMessage(message, parts)));
}

// Resolves to an unpacker when its worker is there.
export async function unpackerInThread() {
  const worker = new Worker(new URL(import.meta.url));
  const unpacker = new Unpacker();
  unpacker.use(worker);
  await new Promise((ready) => {
    worker.on("message", (data) => {
      worker.onmessage({ data });
      ready();
    });
  });
  return unpacker;
}
