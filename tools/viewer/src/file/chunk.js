// One chunk of splits, unpacked into arrays. Each is unpacked by itself.
import { inflateSync } from "fflate";
import { ByteReader, checksumOf } from "./bytes.js";
import { Damaged } from "./damaged.js";

export function openChunk(packed, entry, width) {
  if (checksumOf(packed) !== entry.checksum) throw new Damaged("it is not what was written");
  const reader = new ByteReader(inflated(packed, entry.rawBytes));
  const kinds = reader.section();
  const anchors = anchorsOf(reader.section());
  const rings = reader.section();
  const counts = reader.section();
  const varints = reader.section();
  if (kinds.length !== entry.splits || reader.left() % (4 * width) !== 0)
    throw new Damaged("it does not have the splits that it should");
  const differences = joined(reader.bytes.subarray(reader.at), width);
  return { kinds, anchors, rings, counts, varints, differences, rows: differences.length / width };
}

function inflated(packed, rawBytes) {
  let raw;
  try {
    // With room for one more, so that what is too long shows.
    raw = inflateSync(packed, { out: new Uint8Array(rawBytes + 1) });
  } catch {
    throw new Damaged("it cannot be unpacked");
  }
  if (raw.length !== rawBytes) throw new Damaged("it cannot be unpacked");
  return raw;
}

// A table of vertices in ascending order, then for each split which of them.
function anchorsOf(bytes) {
  const cursor = { at: 0 };
  const table = new Int32Array(Math.min(takeVarint(bytes, cursor), bytes.length));
  for (let i = 0, number = 0; i < table.length; ++i)
    table[i] = number = (number + takeVarint(bytes, cursor)) | 0;
  const planes = table.length <= 0x100 ? 1 : table.length <= 0x10000 ? 2
    : table.length <= 0x1000000 ? 3 : 4;
  const count = Math.floor((bytes.length - cursor.at) / planes);
  const anchors = new Int32Array(count);
  for (let i = 0; i < count; ++i) {
    let index = 0;
    for (let k = 0; k < planes; ++k) index |= bytes[cursor.at + k * count + i] << 8 * k;
    if (index >>> 0 >= table.length) throw new Damaged("it names what is not there");
    anchors[i] = table[index];
  }
  return anchors;
}

// The words of a vertex side by side, out of planes of bytes.
function joined(planes, width) {
  const rows = planes.length / (4 * width);
  const words = new Int32Array(rows * width);
  for (let k = 0; k < width; ++k) {
    const low = 4 * k * rows;
    for (let i = 0; i < rows; ++i) {
      const at = low + i;
      const coded = planes[at] | planes[at + rows] << 8 | planes[at + 2 * rows] << 16 |
        planes[at + 3 * rows] << 24;
      words[i * width + k] = (coded >>> 1) ^ -(coded & 1);
    }
  }
  return words;
}

// `cursor.at` goes on behind it.
export function takeVarint(bytes, cursor) {
  let value = 0;
  for (let shift = 0, scale = 1; shift < 35; shift += 7, scale *= 128) {
    if (cursor.at >= bytes.length) throw new Damaged("it ends within a number");
    const part = bytes[cursor.at++];
    if (shift === 28 && part > 15) break;
    value += (part & 0x7f) * scale;
    if (part < 0x80) return value;
  }
  throw new Damaged("it has a number that is too long");
}
