// A progressive file that is read from its beginning on: the header, then chunk after chunk.
import { openChunk } from "./chunk.js";
import { CutShort, Damaged } from "./damaged.js";
import { fixedBytes, headerBytes, parseHeader } from "./header.js";
import { VertexWords } from "./vertex_words.js";

const firstBytes = 1 << 17;  // most headers are shorter, with the base behind them
const mostBytesAtOnce = 1 << 20;
const unpackedAtMost = 64;  // chunks that are kept unpacked

export class ProgressiveFile {
  static async open(source) {
    let head = await source.read(0, firstBytes);
    const size = headerBytes(head.subarray(0, Math.max(fixedBytes, head.length)));
    if (size > head.length && head.length === firstBytes)
      head = joined(head, await source.read(firstBytes, size + firstBytes));
    if (head.length < size) throw new CutShort("its header is not whole");
    const file = new ProgressiveFile(source, parseHeader(head.subarray(0, size)));
    file.keep(head, 0);
    return file;
  }

  constructor(source, header) {
    this.source = source;
    this.header = header;
    this.words = new VertexWords(header.form, header.attributes);
    this.bytesRead = 0;
    this.packed = [];  // of each chunk that was read
    this.open = new Map();  // chunks by number, the last used at the end
    this.reading = null;  // a promise, while something is read
    this.problem = null;  // why no more was read
  }

  // The chunk; null where it is not here yet, and it is fetched. Throws what went wrong with it.
  chunk(number) {
    let chunk = this.open.get(number);
    if (chunk) {
      this.open.delete(number);
    } else {
      if (number >= this.packed.length) {
        this.passOnProblem();
        this.fetch(number);
        return null;
      }
      try {
        chunk = openChunk(this.packed[number], this.header.chunks[number], this.words.width);
      } catch (error) {
        throw named(error, number);
      }
    }
    this.open.set(number, chunk);
    if (this.open.size > unpackedAtMost) this.open.delete(this.open.keys().next().value);
    return chunk;
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
