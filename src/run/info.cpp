#include <winnow/error.hpp>
#include <winnow/info.hpp>

#include "base/budget.hpp"
#include "base/exact_sum.hpp"
#include "base/memory_shares.hpp"
#include "base/per_slot.hpp"
#include "base/text.hpp"
#include "io/arena.hpp"
#include "measure/edge_count.hpp"
#include "measure/face_census.hpp"
#include "progressive/file_header.hpp"
#include "read/for_each_batch.hpp"
#include "read/mesh_reader.hpp"
#include "run/progressive_info.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

namespace winnow {

namespace {

struct InfoMemory {
  ReaderMemory reader;
  FaceCensus::Memory census;

  static InfoMemory divide(std::uint64_t total, unsigned threads) {
    const std::uint64_t fixed = 12 * mebibyte + threads * 2 * mebibyte;
    constexpr std::uint64_t least = 16 * mebibyte;
    if (total < fixed + least) {
      throw Error(ErrorKind::resources, "a memory budget of " + human_bytes(total) +
                                            " is too small; the smallest that works is `memory` " +
                                            size_option(fixed + least));
    }
    const std::uint64_t rest = total - fixed;
    return {{share::info::reading(rest), 2048},
            {share::info::edges(rest), share::info::pieces(rest)}};
  }
};

InfoReport info_in_arena(Job& job, std::unique_ptr<ByteSource> source, const std::string& input,
                         Format from) {
  const Stopwatch watch;
  const InfoMemory memory = InfoMemory::divide(job.context.memory, job.threads);
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, std::move(source), from, Access::once, memory.reader);
  const InputFacts& facts = reader->facts();

  std::optional<std::uint64_t> positions = facts.vertices;
  if (!positions && facts.faces) positions = 3 * *facts.faces;
  const Point origin = reader->first_finite_position().value_or(Point{});
  FaceCensus census(job, memory.census, origin, positions);
  job.progress.begin("read faces", facts.faces.value_or(0), "faces");
  // Vertices that no face uses belong to the box, too.
  if (facts.vertices) {
    for_each_position_batch(job, *reader,
                            [&](const PositionView& view) { census.add_positions(view); });
  }
  reader->begin_faces();
  const bool corners_too = !facts.vertices;
  for_each_face_batch(job, *reader,
                      [&](const FaceBatch& faces) {
                        census.add_faces(faces);
                        if (corners_too) census.add_corners(faces);
                      },
                      {});

  InfoReport report = census.finish();
  report.name = input;
  report.format = facts.format;
  report.bytes = reader->bytes();
  report.vertices = facts.vertices.value_or(0);
  report.attributes = facts.attributes;
  report.spilled_bytes = job.scratch.written();
  report.peak_scratch_bytes = job.scratch.peak();
  report.seconds = watch.seconds();
  report.peak_memory_bytes = peak_resident_bytes();
  report.notes = job.notes;
  return report;
}

}  // namespace

InfoReport info(Context& context, const std::string& input, Format from) {
  Job job(context);
  return in_arena(job, [&] { return info_in_arena(job, open_source(job, input), input, from); });
}

std::variant<InfoReport, ProgressiveInfo> info_of_any(Context& context, const std::string& input,
                                                      Format from) {
  using Report = std::variant<InfoReport, ProgressiveInfo>;
  Job job(context);
  return in_arena(job, [&]() -> Report {
    std::unique_ptr<ByteSource> source = open_source(job, input);
    if (from == Format::automatic && begins_progressive(*source))
      return info_of_progressive(job, *source, input);
    return info_in_arena(job, std::move(source), input, from);
  });
}

}  // namespace winnow
