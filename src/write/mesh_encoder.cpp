#include "write/mesh_encoder.hpp"

#include <algorithm>

namespace winnow {

std::unique_ptr<MeshEncoder> make_encoder(Format format, const std::string& path) {
  if (format == Format::automatic) {
    std::string ending = path.size() < 4 ? "" : path.substr(path.size() - 4);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    format = ending == ".stl" ? Format::stl : Format::ply;
  }
  return format == Format::stl ? make_stl_encoder() : make_ply_encoder();
}

}  // namespace winnow
