// What files are that are given instead of meshes.
#pragma once

#include "io/byte_source.hpp"

#include <string>
#include <string_view>

namespace winnow {

// Throws Error(bad_input) where the first bytes are those of a known format that is not read. It
// names the format and the way out.
void refuse_foreign(ByteSource& source);

// Of a text that is no mesh, what it is: "it is some other text".
std::string kind_of_text(std::string_view head);

}  // namespace winnow
