// The page with its files in it: one HTML file that needs no server.
#pragma once

#include <winnow/context.hpp>

#include "viewer/shown_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace winnow::viewer {

// Browsers hold no longer text than about this, and the files are a third longer in it.
inline constexpr std::uint64_t most_exported_bytes = std::uint64_t{384} << 20;

// Writes `output`, which appears whole or not at all. Throws Error: usage (it exists, without
// `force`; a file is too large), resources, cancelled.
void export_page(const Context& context, std::string_view page, const std::vector<ShownFile>& files,
                 const std::string& output, bool force);

}  // namespace winnow::viewer
