// Unpacks chunks beside the page, in a worker, as soon as that is there; until then, and where
// there is none, at once.
import { openChunk } from "./chunk.js";
import { Damaged } from "./damaged.js";

// In the worker: gives what is to be done with each message. `post` sends to the page.
export function serveUnpacking(post) {
  post({ ready: true }, []);
  return ({ id, packed, entry, width }) => {
    try {
      const chunk = openChunk(packed, entry, width);
      const parts = [chunk.kinds, chunk.anchors, chunk.differences];
      post({ id, chunk }, parts.map((part) => part.buffer));
    } catch (error) {
      post({ id, problem: error.message }, []);
    }
  };
}

export class Unpacker {
  constructor() {
    this.worker = null;
    this.ready = false;
    this.sent = 0;
    this.waiting = new Map();  // of each chunk that was sent: what is done with it
  }

  // `worker`: runs serveUnpacking().
  use(worker) {
    this.worker = worker;
    worker.onmessage = ({ data }) => this.take(data);
  }

  // Gives the chunk, or a promise of it. Damaged ones are thrown.
  unpack(packed, entry, width) {
    if (!this.ready) return openChunk(packed, entry, width);
    return new Promise((resolve, reject) => {
      const id = ++this.sent;
      this.waiting.set(id, { resolve, reject });
      const own = packed.slice();
      this.worker.postMessage({ id, packed: own, entry, width }, [own.buffer]);
    });
  }

  take({ ready, id, chunk, problem }) {
    if (ready) {
      this.ready = true;
      return;
    }
    const { resolve, reject } = this.waiting.get(id);
    this.waiting.delete(id);
    if (chunk) resolve(chunk);
    else reject(new Damaged(problem));
  }
}
