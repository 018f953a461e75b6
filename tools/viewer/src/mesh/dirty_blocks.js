// Which items have changed since they were last taken, in blocks of 1024.
const shift = 10;

export class DirtyBlocks {
  constructor() {
    this.blocks = new Uint8Array(0);
  }

  reserve(items) {
    const blocks = (items >> shift) + 1;
    if (blocks <= this.blocks.length) return;
    const longer = new Uint8Array(blocks);
    longer.set(this.blocks);
    this.blocks = longer;
  }

  mark(item) {
    this.blocks[item >> shift] = 1;
  }

  markAll() {
    this.blocks.fill(1);
  }

  // Calls run(begin, end) for each run of blocks with a change among the first `items`.
  take(items, run) {
    const { blocks } = this;
    const end = Math.min(blocks.length, Math.ceil(items / (1 << shift)));
    for (let b = 0; b < end; ++b) {
      if (blocks[b] === 0) continue;
      const begin = b;
      while (b < end && blocks[b] !== 0) ++b;
      run(begin << shift, Math.min(b << shift, items));
    }
    blocks.fill(0, 0, end);
  }
}
