#include "read/formats.hpp"

namespace winnow {

TextMatch match_gltf(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || head[first] != '{') return TextMatch::none;
  for (const char* key : {"\"asset\"", "\"accessors\"", "\"bufferViews\"", "\"buffers\"",
                          "\"meshes\"", "\"nodes\"", "\"scenes\""}) {
    if (head.find(key) != std::string_view::npos) return TextMatch::first;
  }
  return TextMatch::none;
}

}  // namespace winnow
