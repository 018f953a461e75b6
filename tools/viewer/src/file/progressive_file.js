// A progressive file that is read from its beginning on: the header, then chunk after chunk.
import { CutShort, Damaged } from "./damaged.js";
import { fixedBytes, headerBytes, parseHeader } from "./header.js";
import { Unpacker } from "./unpacker.js";
import { VertexWords } from "./vertex_words.js";

const firstBytes = 1 << 17;  // most headers are shorter, with the base behind them
const mostBytesAtOnce = 1 << 20;
const unpackedAtMost = 64;  // chunks that are kept unpacked
export const chunksAhead = 32;  // read and unpacked before they are asked for

export class ProgressiveFile {
  static async open(source, unpacker = new Unpacker()) {
    let head = await source.read(0, firstBytes);
    const size = headerBytes(head.subarray(0, Math.max(fixedBytes, head.length)));
    if (size > head.length && head.length === firstBytes)
      head = joined(head, await source.read(firstBytes, size + firstBytes));
    if (head.length < size) throw new CutShort("its header is not whole");
    const file = new ProgressiveFile(source, parseHeader(head.subarray(0, size)), unpacker);
    file.keep(head, 0);
    return file;
  }

  constructor(source, header, unpacker) {
    this.source = source;
    this.unpacker = unpacker;
    this.header = header;
    this.words = new VertexWords(header.form, header.attributes);
    this.bytesRead = 0;
    this.packed = [];  // of each chunk that was read
    // By number, the last used at the end: chunks, promises of them, or what is wrong with them.
    this.open = new Map();
    this.reading = null;  // a promise, while something is read
    this.problem = null;  // why no more was read
  }

  // The chunk; null where it is not here yet, and it is fetched. Throws what went wrong with it.
  chunk(number) {
    if (number >= this.packed.length) {
      this.passOnProblem();
      this.fetch(number);
      return null;
    }
    const found = this.open.get(number) ?? this.unpack(number);
    this.keepOpen(number, found);
    if (found instanceof Error) throw found;
    return found instanceof Promise ? null : found;
  }

  // What is in the map by then.
  unpack(number) {
    let found = null;
    try {
      found = this.unpacker.unpack(this.packed[number], this.header.chunks[number],
        this.words.width);
      if (found instanceof Promise) {
        found = found.catch((error) => named(error, number)).then((chunk) => {
          if (this.open.has(number)) this.open.set(number, chunk);
        });
      }
    } catch (error) {
      found = named(error, number);
    }
    this.keepOpen(number, found);
    return found;
  }

  keepOpen(number, found) {
    this.open.delete(number);
    this.open.set(number, found);
    if (this.open.size > unpackedAtMost) this.open.delete(this.open.keys().next().value);
  }

  // Has what comes next read, and unpacked where that does not hold up the page.
  readAhead(number) {
    const end = Math.min(number + chunksAhead, this.header.chunks.length);
    this.fetch(end - 1);
    if (!this.unpacker.ready) return;
    for (let i = number; i < Math.min(end, this.packed.length); ++i) {
      if (!this.open.has(i)) this.unpack(i);
    }
  }

  passOnProblem() {
    const { problem } = this;
    // A server that did not answer may do so the next time.
    if (!(problem instanceof CutShort)) this.problem = null;
    if (problem) throw problem;
  }

  // Resolves when chunk() has something to say. Chunks are read in the order of the file, many at
  // once.
  async fetch(number) {
    while (this.packed.length <= number && !this.problem) {
      this.reading ??= this.readMore().catch((error) => {
        this.problem = error;
      }).finally(() => {
        this.reading = null;
      });
      await this.reading;
    }
    await this.open.get(number);
  }

  async readMore() {
    const { chunks } = this.header;
    const first = this.packed.length;
    let last = first;
    const { begin } = chunks[first];
    // Little at first, so that something is seen.
    const most = begin + Math.min(this.bytesRead, mostBytesAtOnce);
    while (last + 1 < chunks.length && chunks[last + 1].end.bytes <= most) ++last;
    this.keep(await this.source.read(begin, chunks[last].end.bytes), begin);
    if (this.packed.length === first)
      throw new CutShort(`it ends after ${this.bytesRead} bytes of ${this.header.full.bytes}`);
  }

  // The next chunks out of bytes that were read, as far as they are whole.
  keep(bytes, begin) {
    const { chunks } = this.header;
    this.bytesRead = Math.max(this.bytesRead, begin + bytes.length);
    for (let i = this.packed.length; i < chunks.length; ++i) {
      if (chunks[i].end.bytes - begin > bytes.length) return;
      this.packed.push(bytes.subarray(chunks[i].begin - begin, chunks[i].end.bytes - begin));
    }
  }
}

function joined(first, second) {
  const both = new Uint8Array(first.length + second.length);
  both.set(first);
  both.set(second, first.length);
  return both;
}

function named(error, number) {
  if (!(error instanceof Damaged)) return error;
  return new Damaged(`chunk ${number} is damaged: ${error.message}`);
}
