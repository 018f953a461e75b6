// How far a simplified sequence is from its original, frame by frame, and how much it flickers.
#pragma once

#include <winnow/api.hpp>
#include <winnow/compare.hpp>
#include <winnow/context.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

struct SequenceComparison {
  std::uint64_t frames = 0;
  std::vector<double> rms;             // symmetric, of each frame; model units
  std::vector<std::uint64_t> flipped;  // faces of each frame
  double mean_rms = 0, worst_rms = 0;  // over the frames; model units
  double mean_rms_percent = 0;         // of each frame's diagonal
  double worst_rms_percent = 0;
  std::uint64_t worst_frame = 0;  // from 0
  std::uint64_t most_flipped = 0, degenerate = 0;

  // The root mean square, over vertices and frames, of the second difference of positions over
  // time. `original`: of the points of the original that were nearest to these vertices in the
  // first frame, each carried along by its face. Nothing with fewer than three frames, with
  // vertices that are not stored (STL), or where frames of the result differ in their number of
  // vertices.
  struct Flicker {
    double simplified = 0, original = 0;  // model units
  };
  std::optional<Flicker> flicker;
  std::uint64_t peak_memory_bytes = 0;
  double seconds = 0;
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, SequenceComparison>
void for_each_field(Report& report, Field&& field) {
  field("frames", report.frames);
  field("rms.mean", report.mean_rms);
  field("rms.worst", report.worst_rms);
  field("rms.mean_percent", report.mean_rms_percent);
  field("rms.worst_percent", report.worst_rms_percent);
  field("rms.worst_frame", report.worst_frame);
  field("rms.of_frames", report.rms);
  field("flipped.most", report.most_flipped);
  field("flipped.of_frames", report.flipped);
  field("degenerate", report.degenerate);
  field("flicker", report.flicker);
  field("peak_memory_bytes", report.peak_memory_bytes);
  field("seconds", report.seconds);
}

// Compares each original with the simplified mesh of the same place in the list. `samples`: as in
// CompareOptions, for each frame. Throws Error as compare() does; usage where there are not as many
// of both.
WINNOW_API SequenceComparison compare_sequence(Context& context,
                                               const std::vector<std::string>& originals,
                                               const std::vector<std::string>& simplified,
                                               std::uint64_t samples = 1'000'000);

// The same. Of `options` count `samples`; and with `picture`, `view`, `viewer` and `force`: a PNG
// of up to eight frames beside each other, above as they were, below as they are simplified.
WINNOW_API SequenceComparison compare_sequence(Context& context,
                                               const std::vector<std::string>& originals,
                                               const std::vector<std::string>& simplified,
                                               const CompareOptions& options);

}  // namespace winnow
