// Numbers out of bytes that may end too early.
import { Damaged } from "./damaged.js";

export class ByteReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }

  left() {
    return this.bytes.length - this.at;
  }

  u32() {
    return this.view.getUint32(this.take(4), true);
  }

  f64() {
    return this.view.getFloat64(this.take(8), true);
  }

  point() {
    return [this.f64(), this.f64(), this.f64()];
  }

  text(size) {
    const begin = this.take(size);
    return new TextDecoder().decode(this.bytes.subarray(begin, begin + size));
  }

  // The bytes of a part whose size comes first.
  section() {
    const size = this.u32();
    const begin = this.take(size);
    return this.bytes.subarray(begin, begin + size);
  }

  take(size) {
    if (size > this.left()) throw new Damaged("it is too short for what it tells of");
    const begin = this.at;
    this.at += size;
    return begin;
  }
}

const crcTable = Int32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
});

// CRC-32, as zlib has it.
export function checksumOf(bytes) {
  let crc = -1;
  for (let i = 0; i < bytes.length; ++i) crc = crcTable[(crc ^ bytes[i]) & 0xff] ^ (crc >>> 8);
  return ~crc >>> 0;
}
