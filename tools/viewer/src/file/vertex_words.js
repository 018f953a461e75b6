// Vertices are words of 32 bits of which near ones are near numbers: back to coordinates, colours
// and what else they carry.

const bits = new Int32Array(2);
const asFloat = new Float32Array(bits.buffer);
const asDouble = new Float64Array(bits.buffer);

function floatOf(ordinal) {
  bits[0] = ordinal < 0 ? ordinal & 0x7fffffff : ~ordinal;
  return asFloat[0];
}

function doubleOf(high, low) {
  bits[1] = high < 0 ? high & 0x7fffffff : ~high;
  bits[0] = high < 0 ? low : ~low;
  return asDouble[0];
}

// By the names that programs give them: 0 red, 1 green, 2 blue.
function componentNamed(name) {
  for (const names of [["red", "green", "blue"],
    ["diffuse_red", "diffuse_green", "diffuse_blue"], ["r", "g", "b"]]) {
    if (names.includes(name)) return names.indexOf(name);
  }
  return -1;
}

function fullComponent({ full, type }) {
  if (full > 0) return full;
  return type === "uchar" ? 255 : type === "ushort" ? 65535 : 1;
}

function srgbOfLight(light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
}

export class VertexWords {
  constructor(form, attributes) {
    this.form = form;
    this.attributes = attributes;
    this.width = form.bits === 0 && form.doubles ? 6 : 3;
    this.offsets = [];
    for (const { type } of attributes) {
      this.offsets.push(this.width);
      this.width += type === "double" ? 2 : 1;
    }
    this.colors = [];  // attributes that are red, green and blue
    attributes.forEach(({ kind, name }, i) => {
      const component = kind === "color" || kind === "light" ? componentNamed(name) : -1;
      if (component >= 0) this.colors[component] = i;
    });
    this.hasColors = this.colors.filter((i) => i !== undefined).length === 3;
  }

  // One coordinate of the vertex whose words begin at `at`, as the file has it.
  coordinate(words, at, axis) {
    const { form } = this;
    if (form.bits > 0) {
      const place = form.origin[axis] + form.step * words[at + axis];
      return form.doubles ? place : Math.fround(place);
    }
    if (form.doubles) return doubleOf(words[at + 2 * axis], words[at + 2 * axis + 1]);
    return floatOf(words[at + axis]);
  }

  // What attribute `i` of that vertex is, as the file stores it.
  number(words, at, i) {
    const word = words[at + this.offsets[i]];
    switch (this.attributes[i].type) {
      case "double": return doubleOf(word, words[at + this.offsets[i] + 1]);
      case "float": return floatOf(word);
      case "uint": return word >>> 0;
      default: return word;
    }
  }

  // A component of its colour, as screens have it: 0 to 255.
  colorByte(words, at, component) {
    const i = this.colors[component];
    const attribute = this.attributes[i];
    const share = this.number(words, at, i) / fullComponent(attribute);
    const shown = attribute.kind === "light" ? srgbOfLight(share) : share;
    return Math.round(255 * Math.min(Math.max(shown, 0), 1));
  }
}
