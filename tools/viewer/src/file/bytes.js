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

// By the value of a byte, and how many bytes are behind it.
const crcTables = [Int32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
})];
for (let i = 0; i < 3; ++i)
  crcTables.push(crcTables[i].map((crc) => crcTables[0][crc & 0xff] ^ (crc >>> 8)));

// CRC-32, as zlib has it; four bytes at a time.
export function checksumOf(bytes) {
  const [last, third, second, first] = crcTables;
  let crc = -1, i = 0;
  for (const end = bytes.length - 3; i < end; i += 4) {
    crc ^= bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 | bytes[i + 3] << 24;
    crc = first[crc & 0xff] ^ second[(crc >>> 8) & 0xff] ^ third[(crc >>> 16) & 0xff] ^
      last[crc >>> 24];
  }
  for (; i < bytes.length; ++i) crc = last[(crc ^ bytes[i]) & 0xff] ^ (crc >>> 8);
  return ~crc >>> 0;
}
