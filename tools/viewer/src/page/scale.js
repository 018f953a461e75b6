// The slider: steps 0 to 1000 are counts of faces from all to the fewest, by equal ratios.
const steps = 1000;

export function facesAt(step, smallest, full) {
  return Math.round(full * (smallest / full) ** (step / steps));
}

export function stepOf(faces, smallest, full) {
  if (full <= smallest) return 0;
  return Math.round(steps * Math.log(full / faces) / Math.log(full / smallest));
}
