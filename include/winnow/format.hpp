// File formats, and how a mesh is written in one.
#pragma once

#include <winnow/values.hpp>

#include <array>
#include <optional>

namespace winnow {

// File formats by name; `automatic` goes by content for an input, by the name's ending for an
// output, before a .gz or .zst. `m` is that of Hugues Hoppe's programs; `gltf` is glTF 2.0, which
// is written as GLB.
enum class Format { automatic, ply, stl, obj, off, m, gltf };

struct FormatFacts {
  const char* name = nullptr;            // as an input
  std::array<const char*, 2> endings{};  // of files' names, without the dot; options take them too
  bool read = true;
  const char* written = nullptr;  // its name as an output, which has the first ending; null: it is
                                  // only read
  bool generated = false;         // by generate() as well
};

constexpr FormatFacts facts_of(Format format) {
  switch (format) {
    case Format::automatic:
      return {.name = "auto"};
    case Format::ply:
      return {.name = "PLY", .endings = {"ply"}, .written = "PLY", .generated = true};
    case Format::stl:
      return {.name = "STL", .endings = {"stl"}, .written = "STL", .generated = true};
    case Format::obj:
      return {.name = "OBJ", .endings = {"obj"}, .written = "OBJ", .generated = true};
    case Format::off:
      return {.name = "OFF", .endings = {"off"}, .written = "OFF", .generated = true};
    case Format::m:
      return {.name = ".m", .endings = {"m"}, .written = ".m", .generated = true};
    case Format::gltf:
      return {.name = "glTF", .endings = {"glb", "gltf"}, .written = "GLB"};
  }
  return {};
}

// How a program may use a format.
enum class FormatUse { read, written, generated };

constexpr bool serves(Format format, FormatUse use) {
  const FormatFacts facts = facts_of(format);
  if (facts.endings.front() == nullptr) return false;
  if (use == FormatUse::read) return facts.read;
  return use == FormatUse::written ? facts.written != nullptr : facts.generated;
}

// The type of positions in the output.
enum class Positions {
  as_input,  // doubles where the input has doubles, else floats
  floats,    // rounded; a notice says so where that is coarse for the mesh
  doubles    // not in STL and GLB, which hold floats
};

// How the vertices and faces of a GLB are packed. Compressing the whole file is said by the
// output's name.
enum class Compression {
  none,    // not at all: every reader of glTF 2.0 knows it
  meshopt  // EXT_meshopt_compression: without loss, to less than half; in primitives of 32,768
           // faces, whose order changes
};

// The axis of the model that points up.
enum class UpAxis {
  y,  // as in glTF
  z   // a GLB's node turns the model, whose positions stay; only for GLB
};

// What a format leaves open. Options that make no sense for the format are an Error(usage).
struct Encoding {
  bool ascii = false;  // PLY and STL as text; OBJ and OFF always are
  Positions positions = Positions::as_input;
  Compression compress = Compression::none;  // GLB
  UpAxis up = UpAxis::y;                     // GLB
  // Of a GLB: positions are whole numbers of so many bits, 1 to 16 (KHR_mesh_quantization), along
  // the longest side of the box, and normals of 8; the report says how far a position moves at
  // most. Default: floats.
  std::optional<unsigned> quantize{};
};

}  // namespace winnow
