// The order of a sequence's files, and how those of its result are called.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace winnow {

inline constexpr std::string_view frame_placeholder = "{frame}";

struct FrameNames {
  std::vector<std::string> inputs;  // in the order of the frames
  std::vector<std::string> labels;  // what {frame} stands for
};

// Names that differ in their last number alone are put in the order of that, which is the label;
// others are frames in the order given, with the numbers from 1 on as labels, as long as the last.
FrameNames frame_names(const std::vector<std::string>& inputs);

// From 1 on, as long as the last.
std::vector<std::string> frame_numbers(std::size_t frames);

// `output` with {frame} replaced by each label. Throws Error(usage) where it has none.
std::vector<std::string> names_of_frames(const std::string& output,
                                         const std::vector<std::string>& labels);

}  // namespace winnow
