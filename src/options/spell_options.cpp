#include <winnow/options.hpp>

#include <set>

namespace winnow {

namespace {

template <typename Options>
void add_names(std::span<const Option<Options>> table, std::set<std::string>& names) {
  for (const Option<Options>& option : table) names.insert(option.name);
}

std::set<std::string> all_names() {
  std::set<std::string> names{"checkpoint", "output",      "convert", "extract",
                              "info",       "progressive", "resume",  "simplify"};
  add_names(simplify_options(), names);
  add_names(convert_options(), names);
  add_names(compare_options(), names);
  add_names(progressive_options(), names);
  add_names(extract_options(), names);
  add_names(sequence_options(), names);
  add_names(context_options(), names);
  return names;
}

}  // namespace

std::string spell_options(const std::string& text,
                          const std::function<std::string(const std::string& name)>& spelled) {
  static const std::set<std::string> names = all_names();
  std::string result;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t open = std::min(text.find('`', at), text.size());
    const std::size_t close = text.find('`', open + 1);
    result += text.substr(at, open - at);
    at = open;
    if (close == std::string::npos) break;
    const std::string name = text.substr(open + 1, close - open - 1);
    if (names.count(name) != 0) {
      result += spelled(name);
      at = close + 1;
    } else {
      result += '`';
      at = open + 1;
    }
  }
  return result + text.substr(at);
}

}  // namespace winnow
