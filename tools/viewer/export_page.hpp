// The page with its files in it: one HTML file that needs no server.
#pragma once

#include <winnow/context.hpp>

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "viewer/shown_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace winnow::viewer {

// Browsers hold no longer text than about this, and the files are a third longer in it.
inline constexpr std::uint64_t most_exported_bytes = std::uint64_t{384} << 20;

class ExportedPage {
 public:
  // `output` as all outputs of winnow: it appears whole or not at all. `inputs`: what is read for
  // it. Throws Error: usage (it exists, without `force`; it is an input), resources.
  ExportedPage(Context& context, const std::string& output, bool force,
               const std::vector<std::string>& inputs);

  // Throws Error: usage (a file is too large), bad_input (it was shortened meanwhile), resources,
  // cancelled.
  void write(std::string_view page, const std::vector<ShownFile>& files);

 private:
  void put(std::string_view text);
  void put_file(const ShownFile& file);

  Job job_;
  ByteSink sink_;
};

}  // namespace winnow::viewer
