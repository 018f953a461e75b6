#include "sequence/frame_names.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace winnow {

namespace {

constexpr std::string_view digits = "0123456789";

// A name around the last number in it, which is not of the ending: "frame-0012.ply".
struct Numbered {
  std::string before, number, after;

  // Numbers of any length.
  [[nodiscard]] std::pair<std::size_t, std::string> value() const {
    const std::size_t zeros = std::min(number.find_first_not_of('0'), number.size());
    return {number.size() - zeros, number.substr(zeros)};
  }
};

Numbered numbered(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  const std::size_t file = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t dot = std::min(name.find('.', file + 1), name.size());
  const std::size_t last = name.substr(0, dot).find_last_of(digits);
  if (last == std::string::npos || last < file) return {name, "", ""};
  std::size_t first = last;
  while (first > file && digits.find(name[first - 1]) != std::string_view::npos) --first;
  return {name.substr(0, first), name.substr(first, last + 1 - first), name.substr(last + 1)};
}

std::string padded(std::size_t number, std::size_t width) {
  const std::string text = std::to_string(number);
  return std::string(width - std::min(width, text.size()), '0') + text;
}

}  // namespace

std::vector<std::string> frame_numbers(std::size_t frames) {
  std::vector<std::string> labels;
  const std::size_t width = std::to_string(frames).size();
  for (std::size_t i = 1; i <= frames; ++i) labels.push_back(padded(i, width));
  return labels;
}

FrameNames frame_names(const std::vector<std::string>& inputs) {
  std::vector<Numbered> names;
  std::set<std::pair<std::size_t, std::string>> values;
  bool alike = true;
  for (const std::string& input : inputs) {
    names.push_back(numbered(input));
    const Numbered& name = names.back();
    alike &= !name.number.empty() && name.before == names.front().before &&
             name.after == names.front().after && values.insert(name.value()).second;
  }
  FrameNames out;
  if (alike) {
    std::stable_sort(names.begin(), names.end(),
                     [](const Numbered& a, const Numbered& b) { return a.value() < b.value(); });
    for (const Numbered& name : names) {
      out.inputs.push_back(name.before + name.number + name.after);
      out.labels.push_back(name.number);
    }
    return out;
  }
  out.inputs = inputs;
  out.labels = frame_numbers(inputs.size());
  return out;
}

std::vector<std::string> names_of_frames(const std::string& output,
                                         const std::vector<std::string>& labels) {
  if (output.find(frame_placeholder) == std::string::npos)
    throw Error(ErrorKind::usage,
                "the frames of a sequence need {frame} in the output's name, not '" + output +
                    "'; name files like 'small-{frame}.ply', or one 'small.glb'");
  std::vector<std::string> names;
  for (const std::string& label : labels) {
    std::string name = output;
    for (std::size_t at = name.find(frame_placeholder); at != std::string::npos;
         at = name.find(frame_placeholder, at + label.size()))
      name.replace(at, frame_placeholder.size(), label);
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace winnow
