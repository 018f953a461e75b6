#include "write/mesh_encoder.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <filesystem>

namespace winnow {

std::unique_ptr<MeshEncoder> make_encoder(Format format, const std::string& path) {
  if (format == Format::automatic) {
    std::string ending = path.size() < 4 ? "" : path.substr(path.size() - 4);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    format = ending == ".stl" ? Format::stl : Format::ply;
    for (const char* other : {".obj", ".off", ".glb", ".gltf", ".3mf", ".gz", ".zst"}) {
      if (std::filesystem::path(path).extension() != other) continue;
      throw Error(ErrorKind::usage, "'" + path + "': " + other +
                                        " is not written; name the output .ply or .stl, or say --to ply");
    }
  }
  if (format != Format::ply && format != Format::stl)
    throw Error(ErrorKind::usage, "this format is only read; --to takes ply or stl");
  return format == Format::stl ? make_stl_encoder() : make_ply_encoder();
}

}  // namespace winnow
