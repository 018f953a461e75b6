#include "table_options.hpp"

namespace winnow::cli {

std::string flag_called(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::string spoken(const std::string& text) {
  return spell_options(text, [](const std::string& name) {
    const bool command = name == "simplify" || name == "resume" || name == "convert" ||
                         name == "info" || name == "progressive" || name == "extract";
    return command ? "winnow " + name : flag_called(name);
  });
}

std::string spoken(const std::string& text, const std::string& option) {
  const std::string quoted = "`" + option + "`";
  std::string result = text;
  for (std::size_t at = 0; (at = result.find(quoted, at)) != std::string::npos;)
    result.replace(at, quoted.size(), flag_called(option));
  return spoken(result);
}

std::vector<std::string> spoken(std::vector<std::string> texts) {
  for (std::string& text : texts) text = spoken(text);
  return texts;
}

std::string open_choice(const std::string& takes, const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += word + ",";
  return takes + ":{" + list + "...}";
}

}  // namespace winnow::cli
