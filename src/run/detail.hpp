// How much of the input refinement starts from.
#pragma once

#include <winnow/simplify.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace winnow {

// Faces that are asked for, of so many in the input; nothing where a cell or an error says how
// many.
std::optional<std::uint64_t> faces_wanted(const Target& target, std::uint64_t available);

// What refinement starts from: all faces, welded, or as many as clustering leaves.
struct Detail {
  bool welded = false;
  std::uint64_t faces = 0;
  std::string reason{};
};
Detail detail_for(const SimplifyOptions& options, std::uint64_t available, std::uint64_t target);
// The same where an error is asked for; nothing in `reason` where it only shows later.
Detail detail_for_error(const SimplifyOptions& options, std::uint64_t available);

// Inputs of no more faces are refined from all of them.
inline constexpr std::uint64_t always_full = std::uint64_t{1} << 20;

}  // namespace winnow
