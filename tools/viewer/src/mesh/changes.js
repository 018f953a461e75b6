// Which items have changed since they were last taken: each of them, and blocks of 1024 with a
// change, as much as is worth sending to a graphics card at once.
const shift = 10;

export class Changes {
  constructor() {
    this.all = true;
    this.marked = new Uint8Array(0);  // of each item
    this.items = new Int32Array(0);  // those that are marked
    this.count = 0;
    this.blocks = new Uint8Array(0);
  }

  // Room for so many; what has changed until now is taken for all.
  reserve(items) {
    if (items <= this.marked.length) return;
    this.marked = new Uint8Array(items);
    this.items = new Int32Array(items);
    this.blocks = new Uint8Array((items >> shift) + 1);
    this.count = 0;
    this.all = true;
  }

  mark(item) {
    if (this.all || this.marked[item] !== 0) return;
    this.marked[item] = 1;
    this.items[this.count++] = item;
    this.blocks[item >> shift] = 1;
  }

  any() {
    return this.all || this.count > 0;
  }

  markAll() {
    this.all = true;
  }

  // Of the first `end` items: each(item) for those that have changed, then run(begin, end) for
  // ranges that hold all of them.
  take(end, each, run) {
    if (this.all) {
      for (let item = 0; item < end; ++item) each(item);
      if (end > 0) run(0, end);
    } else {
      for (let i = 0; i < this.count; ++i) {
        if (this.items[i] < end) each(this.items[i]);
      }
      this.takeBlocks(end, run);
    }
    for (let i = 0; i < this.count; ++i) this.marked[this.items[i]] = 0;
    this.blocks.fill(0);
    this.count = 0;
    this.all = false;
  }

  takeBlocks(items, run) {
    const { blocks } = this;
    const end = Math.min(blocks.length, Math.ceil(items / (1 << shift)));
    for (let b = 0; b < end; ++b) {
      if (blocks[b] === 0) continue;
      const begin = b;
      while (b < end && blocks[b] !== 0) ++b;
      run(begin << shift, Math.min(b << shift, items));
    }
  }
}
