// OBJ and Hoppe's .m: positions and faces as lines. Both count from 1.
const linesAtOnce = 1 << 16;

export function objOf(shot) {
  return linesOf(shot, (_, place) => `v ${place}`, (_, corners) => `f ${corners}`);
}

export function mOf(shot) {
  return linesOf(shot, (v, place) => `Vertex ${v} ${place}`,
    (f, corners) => `Face ${f} ${corners}`);
}

function linesOf(shot, vertexLine, faceLine) {
  const digits = shot.words.form.doubles ? String : floatDigits;
  const parts = [];
  let lines = [];
  const add = (line) => {
    lines.push(line);
    if (lines.length === linesAtOnce) flush();
  };
  const flush = () => {
    parts.push(lines.map((line) => `${line}\n`).join(""));
    lines = [];
  };
  for (let v = 0; v < shot.vertexCount; ++v) {
    const place = [0, 1, 2].map((axis) => digits(shot.coordinate(v, axis)));
    add(vertexLine(v + 1, place.join(" ")));
  }
  for (let f = 0; f < shot.faceCount; ++f) {
    const corners = [0, 1, 2].map((i) => shot.corners[3 * f + i] + 1);
    add(faceLine(f + 1, corners.join(" ")));
  }
  flush();
  return new Blob(parts);
}

// The fewest digits from which the same float comes back.
function floatDigits(x) {
  for (let digits = 6; digits < 9; ++digits) {
    const text = String(Number(x.toPrecision(digits)));
    if (Math.fround(Number(text)) === x) return text;
  }
  return String(Number(x.toPrecision(9)));
}
