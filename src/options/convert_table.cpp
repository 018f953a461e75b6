// The table of convert().
#include "options/option_kinds.hpp"
#include "options/shared_entries.hpp"

namespace winnow {

std::span<const Option<ConvertOptions>> convert_options() {
  static const std::vector<Option<ConvertOptions>> options = [] {
    std::vector<Option<ConvertOptions>> table{strict_option<ConvertOptions>(),
                                              from_option<ConvertOptions>(&ConvertOptions::from)};
    add_output_options(table);
    return table;
  }();
  return options;
}

}  // namespace winnow
