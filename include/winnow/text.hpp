// Numbers and lists as winnow writes them for people.
#pragma once

#include <winnow/api.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace winnow {

WINNOW_API std::string human_bytes(std::uint64_t bytes);  // "512 MiB", "1.5 GiB", "84 bytes"
WINNOW_API std::string grouped(std::uint64_t count);      // "1,234,567"
WINNOW_API std::string either(const std::vector<std::string>& words);  // "PLY, OBJ or OFF"

}  // namespace winnow
