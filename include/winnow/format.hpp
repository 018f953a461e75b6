// File formats, and how a mesh is written in one.
#pragma once

namespace winnow {

// File formats by name; `automatic` goes by content for an input, by the name's ending for an output, before
// a .gz or .zst. OBJ, OFF and GLB (binary glTF 2.0) are written, not read.
enum class Format { automatic, ply, stl, obj, off, glb };

// The type of positions in the output.
enum class Positions {
  as_input,  // doubles where the input has doubles, else floats
  floats,    // rounded; a notice says so where that is coarse for the mesh
  doubles    // not in STL and GLB, which hold floats
};

// What a format leaves open. Options that make no sense for the format are an Error(usage).
struct Encoding {
  bool ascii = false;  // PLY and STL as text; OBJ and OFF always are
  Positions positions = Positions::as_input;
};

}  // namespace winnow
