// The head of a progressive file: docs/progressive_format.md.
import { ByteReader, checksumOf } from "./bytes.js";
import { CutShort, Damaged } from "./damaged.js";

export const fixedBytes = 128;
const version = 2;
const magic = [0x89, 0x57, 0x50, 0x4d, 0x0d, 0x0a, 0x1a, 0x0a];
const checksumAt = 16;
const entryBytes = 32;
const mostChunkBytes = 1 << 26;
const mostHeaderBytes = 1 << 28;
const mostName = 1024;

export const numberTypes = ["char", "uchar", "short", "ushort", "int", "uint", "int64", "uint64",
  "float", "double"];
const kinds = ["value", "color", "normal", "light", "label"];
const costs = ["none", "quadric", "volume", "importance"];

// How many bytes the header has, told by its first ones.
export function headerBytes(bytes) {
  if (!magic.every((byte, i) => bytes[i] === byte))
    throw new Damaged("it is no progressive mesh; 'winnow progressive' makes one");
  if (bytes.length < fixedBytes) throw new CutShort("its header is not whole");
  const reader = new ByteReader(bytes);
  reader.take(magic.length);
  const found = reader.u32();
  if (found !== version)
    throw new Damaged(`it has version ${found} of the format, and this page reads ${version}`);
  const size = reader.u32();
  if (size < fixedBytes || size > mostHeaderBytes)
    throw new Damaged("its header cannot be so long");
  return size;
}

// `bytes`: as many as headerBytes() says.
export function parseHeader(bytes) {
  const reader = new ByteReader(bytes);
  reader.take(checksumAt);
  checkIntact(bytes, reader.u32());
  const doubles = reader.u32() === 1;
  const form = { doubles, bits: reader.u32(), origin: reader.point(), step: reader.f64() };
  const box = { low: reader.point(), high: reader.point() };
  const cost = costs[reader.u32()];
  const normals = reader.u32() !== 0;
  const attributeCount = reader.u32();
  const baseChunks = reader.u32();
  const chunkCount = reader.u32();
  const attributes = Array.from({ length: attributeCount }, () => takeAttribute(reader));
  if (reader.left() !== entryBytes * chunkCount || baseChunks > chunkCount)
    throw new Damaged("its header does not have as many chunks as it says");
  const chunks = [];
  const end = { vertices: 0, faces: 0, bytes: bytes.length };
  for (let i = 0; i < chunkCount; ++i) chunks.push(takeEntry(reader, end));
  if (3 * end.faces >= 2 ** 31 || end.vertices >= 2 ** 31)
    throw new Damaged("it has more faces than a page can show");
  const base = baseChunks > 0 ? chunks[baseChunks - 1].end : { ...end, vertices: 0, faces: 0 };
  return { form, box, cost, normals, attributes, chunks, baseChunks, base, full: end };
}

// Within which the mesh keeps the surface of the whole file, with so many chunks of it.
export function errorOf(header, chunkCount) {
  const { form, box, chunks } = header;
  if (chunkCount < chunks.length) return chunks[chunkCount].error;
  if (form.bits === 0) return 0;
  // Of a lattice: half a step on each axis, and what floats leave out.
  const most = Math.max(...[...box.low, ...box.high].map(Math.abs));
  return (form.step / 2 + (form.doubles ? 0 : most * 2 ** -24)) * Math.sqrt(3);
}

function checkIntact(bytes, checksum) {
  const unsigned = Uint8Array.from(bytes);
  unsigned.fill(0, checksumAt, checksumAt + 4);
  if (checksumOf(unsigned) !== checksum) throw new Damaged("its header is not what was written");
}

function takeAttribute(reader) {
  const type = numberTypes[reader.u32()];
  const kind = kinds[reader.u32()];
  reader.u32();  // whether a number says that there is none
  const size = reader.u32();
  if (!type || !kind || type.endsWith("64") || size > mostName)
    throw new Damaged("an attribute is of no known type");
  const full = reader.f64();
  reader.f64();
  const name = reader.text(Math.ceil(size / 4) * 4).slice(0, size);
  return { name, type, kind, full };
}

// `end`: where all chunks up to this one end.
function takeEntry(reader, end) {
  const begin = end.bytes;
  const entry = { begin, bytes: reader.u32(), rawBytes: reader.u32(), splits: reader.u32() };
  end.vertices += reader.u32();
  end.faces += reader.u32();
  end.bytes += entry.bytes;
  entry.checksum = reader.u32();
  entry.error = reader.f64();
  if (entry.rawBytes > mostChunkBytes || entry.splits > entry.rawBytes)
    throw new Damaged("a chunk is larger than one can be");
  entry.end = { ...end };
  return entry;
}
