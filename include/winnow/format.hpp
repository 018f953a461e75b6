// File formats, and how a mesh is written in one.
#pragma once

namespace winnow {

// File formats by name; `automatic` goes by content for an input, by the name's ending for an output, before
// a .gz or .zst. `m` is read, not written; `gltf` is glTF 2.0, which is written as GLB.
enum class Format { automatic, ply, stl, obj, off, m, gltf };

// The type of positions in the output.
enum class Positions {
  as_input,  // doubles where the input has doubles, else floats
  floats,    // rounded; a notice says so where that is coarse for the mesh
  doubles    // not in STL and GLB, which hold floats
};

// How the vertices and faces of a GLB are packed. Compressing the whole file is said by the output's name.
enum class Compression {
  none,    // not at all: every reader of glTF 2.0 knows it
  meshopt  // EXT_meshopt_compression: without loss, to less than half; in primitives of 32,768 faces
};

// What a format leaves open. Options that make no sense for the format are an Error(usage).
struct Encoding {
  bool ascii = false;  // PLY and STL as text; OBJ and OFF always are
  Positions positions = Positions::as_input;
  Compression compression = Compression::none;  // GLB
};

}  // namespace winnow
