#include "report_text.hpp"

#include "numbers.hpp"

#include <algorithm>

namespace winnow::cli {

Json json_of_bad_faces(const BadFaces& bad) {
  return {{"degenerate", bad.degenerate}, {"non_finite", bad.non_finite}, {"out_of_range", bad.out_of_range}};
}

void Lines::operator()(const std::string& name, const std::string& text) const {
  out_ << "  " << name << std::string(column_ - std::min(column_ - 1, name.size()), ' ') << clean(text)
       << "\n";
}

void Lines::notes(const std::vector<std::string>& notes) const {
  for (const std::string& note : notes) (*this)("note", note);
}

std::string show_time(double seconds, std::uint64_t faces) {
  return show_seconds(seconds) + "  (" + show_rate(static_cast<double>(faces) / seconds) + "faces/s)";
}

std::string show_memory(std::uint64_t peak, std::uint64_t scratch) {
  std::string text = show_bytes(peak) + " at its peak";
  if (scratch > 0) text += ", and " + show_bytes(scratch) + " of scratch";
  return text;
}

}  // namespace winnow::cli
