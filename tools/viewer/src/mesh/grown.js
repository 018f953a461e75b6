// A typed array with room for so many numbers: the same one, or a longer copy.
export function grown(array, length) {
  if (length <= array.length) return array;
  const longer = new array.constructor(length);
  longer.set(array);
  return longer;
}

// How much room to make for so many items, so that they seldom move.
export function roomFor(items, room) {
  return items <= room ? room : Math.max(items, Math.ceil(1.5 * room), 1024);
}
