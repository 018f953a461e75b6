#include "run/read_sequence.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "measure/result_surface.hpp"
#include "run/attributes.hpp"
#include "run/detail.hpp"

#include <algorithm>
#include <vector>

namespace winnow {

namespace {

// What frames remove by themselves, of so many faces.
std::uint64_t rounded_part(double part, std::uint64_t faces, std::uint64_t wanted) {
  const auto removed = static_cast<double>(faces - std::min(faces, wanted));
  return static_cast<std::uint64_t>(part * removed + 0.5);
}

[[noreturn]] void refuse_memory(const Job& job, const MemoryPlan& plan, std::uint64_t vertices,
                                std::uint64_t bytes) {
  const std::uint64_t missing = bytes - plan.cluster.table;
  const std::uint64_t enough = job.budget.total() + share::plan::cells.whole(missing);
  throw Error(ErrorKind::resources,
              "a memory budget of " + human_bytes(job.budget.total()) +
                  " is too small for frames of " + grouped(vertices) +
                  " vertices, one of which is held in memory; enough is `memory` " +
                  size_option((enough / mebibyte + 2) * mebibyte));
}

}  // namespace

ReadSequence read_sequence(Job& job, FrameReaders& readers, const MemoryPlan& plan,
                           const SequenceOptions& options) {
  ReadSequence read;
  SequenceMesh& sequence = read.sequence;
  {
    const std::uint64_t quarter = plan.cluster.faces;
    FrameIntake intake(
        job, readers, {plan.reader, plan.cluster.table, quarter / 2, quarter / 2 * 3, quarter / 4});
    sequence = intake.run([&](std::uint64_t vertices,
                              std::uint64_t bytes) { refuse_memory(job, plan, vertices, bytes); },
                          [&](std::vector<Attribute>& attributes,
                              const std::vector<MeshReader::AttributeRange>& ranges) {
                            settle_colors(job, attributes, ranges);
                          });
  }
  note_dropped(job, sequence.dropped);
  const std::uint64_t faces = sequence.mesh.face_count;
  if (faces == 0)
    throw Error(ErrorKind::bad_input, readers.name(0) + " has no face that could be simplified");
  SequenceReport& report = read.report;
  report.input.format = sequence.format;
  report.input.frames = sequence.frames;
  report.input.faces = sequence.faces;
  report.input.vertices = sequence.vertices;
  report.input.bytes = sequence.bytes;
  report.joined = sequence.joined;
  report.bad_faces = sequence.bad_faces;
  report.area.input = area_of(job, sequence.mesh);
  report.target_faces = faces_wanted(options.target, faces).value_or(0);
  read.faces = report.target_faces + rounded_part(options.per_frame, faces, report.target_faces);
  return read;
}

}  // namespace winnow
