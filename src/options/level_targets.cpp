#include "options/level_targets.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "options/text_values.hpp"

#include <algorithm>

namespace winnow {

namespace {

// Of the kinds that several can be asked for.
std::string option_of(const Target& target) {
  return target.faces() ? "faces" : target.ratio() ? "ratio" : target.error() ? "error" : "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

// What the files are that several targets need one each of, and how they may be named.
struct LevelFiles {
  std::string name_of;  // whose name it is
  std::string one;
  std::string example_start, example_end;
};

std::vector<std::string> level_names(const std::string& name, const SimplifyOptions& options,
                                     const LevelFiles& files) {
  const std::string option = option_of(options.target);
  const std::string place = "{" + option + "}";
  const std::vector<Target> targets = targets_of(options);
  if (targets.size() > 1 && name.find(place) == std::string::npos) {
    throw Error(ErrorKind::usage, "several values of `" + option + "` need " + place + " in " +
                                      files.name_of + ", not '" + name + "'; name files like '" +
                                      files.example_start + place + files.example_end + "'");
  }
  std::vector<std::string> names;
  for (const Target& target : targets) {
    names.push_back(option.empty() ? name : replaced(name, place, text_of(target)));
    if (std::count(names.begin(), names.end(), names.back()) > 1)
      throw Error(ErrorKind::usage, "`" + option + "` asks for " + text_of(target) + " twice: '" +
                                        names.back() + "' can hold only one " + files.one);
  }
  return names;
}

}  // namespace

bool is_finer(const Target& a, const Target& b) {
  if (a.faces()) return a.faces() > b.faces();
  if (a.ratio()) return a.ratio() > b.ratio();
  return a.error() && b.error() && a.error()->relative == b.error()->relative &&
         a.error()->value < b.error()->value;
}

std::vector<Target> targets_of(const SimplifyOptions& options) {
  std::vector<Target> targets{options.target};
  targets.insert(targets.end(), options.coarser.begin(), options.coarser.end());
  return targets;
}

std::string text_of(const Target& target) {
  if (target.faces()) return std::to_string(*target.faces());
  if (target.ratio()) return shortest(*target.ratio());
  return target.error() ? text_of(*target.error()) : "";
}

std::vector<std::string> output_names(const std::string& output, const SimplifyOptions& options) {
  const LevelFiles files{"the output's name", "mesh", "small-", ".ply"};
  if (!options.coarser.empty() && output == "-") {
    throw Error(ErrorKind::usage,
                "several meshes cannot all go to standard output; name files like 'small-{" +
                    option_of(options.target) + "}.ply'");
  }
  return level_names(output, options, files);
}

std::vector<std::string> map_names(const SimplifyOptions& options) {
  if (options.map.empty()) return {};
  return level_names(options.map, options, {"the name of `map`", "map", "map-", ".npy"});
}

}  // namespace winnow
