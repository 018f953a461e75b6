// A progressive file that is read from its beginning on: the header, then chunk after chunk.
import { openChunk } from "./chunk.js";
import { CutShort, Damaged } from "./damaged.js";
import { fixedBytes, headerBytes, parseHeader } from "./header.js";
import { VertexWords } from "./vertex_words.js";

const firstBytes = 1 << 16;  // most headers are shorter
const mostBytesAtOnce = 1 << 20;
const unpackedAtMost = 64;  // chunks that are kept unpacked

export class ProgressiveFile {
  static async open(source) {
    let head = await source.read(0, firstBytes);
    const size = headerBytes(head.subarray(0, Math.max(fixedBytes, head.length)));
    if (size > head.length) head = await source.read(0, size);
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
    this.open = new Map();  // chunks by number, the last used at the end: a promise or a chunk
    this.reading = Promise.resolve();
  }

  // The chunk if it is unpacked; else null, and it is fetched. Throws what went wrong with it.
  chunk(number) {
    const known = this.open.get(number);
    if (known) {
      this.open.delete(number);
      this.open.set(number, known);
    } else {
      this.fetch(number).catch(() => {});
    }
    if (known instanceof Error) {
      // A server that did not answer may do so the next time.
      if (!(known instanceof Damaged || known instanceof CutShort)) this.open.delete(number);
      throw known;
    }
    return known === undefined || known instanceof Promise ? null : known;
  }

  // Resolves when chunk() has something to say.
  fetch(number) {
    const known = this.open.get(number);
    if (known instanceof Promise) return known;
    if (known) return Promise.resolve();
    const fetched = this.read(number).then((packed) =>
      openChunk(packed, this.header.chunks[number], this.words.width));
    const settled = fetched.then(
      (chunk) => this.open.set(number, chunk),
      (error) => this.open.set(number, named(error, number)));
    this.open.set(number, settled);
    this.forgetOldest();
    return settled;
  }

  // Chunks that will be wanted soon.
  prefetch(number, count) {
    const end = Math.min(number + count, this.header.chunks.length);
    for (let i = number; i < end; ++i) this.fetch(i);
  }

  forgetOldest() {
    for (const [number, chunk] of this.open) {
      if (this.open.size <= unpackedAtMost) return;
      if (!(chunk instanceof Promise)) this.open.delete(number);
    }
  }

  // Chunks are read in the order of the file, many at once.
  async read(number) {
    while (this.packed.length <= number) {
      this.reading = this.reading.catch(() => {}).then(() => this.readMore(number));
      await this.reading;
    }
    return this.packed[number];
  }

  async readMore(number) {
    const { chunks } = this.header;
    const first = this.packed.length;
    if (first > number) return;
    let last = first;
    const { begin } = chunks[first];
    // Little at first, so that something is seen.
    const most = begin + Math.min(this.bytesRead, mostBytesAtOnce);
    while (last + 1 < chunks.length && chunks[last + 1].end.bytes <= most) ++last;
    this.keep(await this.source.read(begin, chunks[last].end.bytes), begin);
    if (this.packed.length <= number)
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

function named(error, number) {
  if (!(error instanceof Damaged)) return error;
  return new Damaged(`chunk ${number} is damaged: ${error.message}`);
}
