// The page that shows progressive meshes, as one HTML file.
#pragma once

#include <string_view>

namespace winnow::viewer {

// Empty where the program was built without it.
std::string_view page();

// In the page: what is put here comes before its script.
inline constexpr std::string_view mesh_mark = "<!--mesh-->";

}  // namespace winnow::viewer
