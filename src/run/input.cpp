#include "run/input.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/cropped_reader.hpp"
#include "read/joined_reader.hpp"
#include "read/view_arrays.hpp"
#include "read/view_reader.hpp"
#include "run/simplify_options.hpp"

namespace winnow {

Input::Input(Job& job, const std::vector<std::string>& names) : job_(job), names_(names) {
  if (names.empty()) throw Error(ErrorKind::usage, "there is no input");
  if (names.size() > 1) {
    memory_ = memory_to_open(job, names);
    return;
  }
  source_ = open_source(job, names.front());
  source_->peek(1);
  memory_ = job.budget.used();
}

Input::Input(Job& job, std::unique_ptr<ByteSource> source) : job_(job), source_(std::move(source)) {
  source_->peek(1);
  memory_ = job.budget.used();
}

Input::Input(Job& job, const MeshView& mesh) : job_(job), mesh_(&mesh), memory_(job.budget.used()) {
  check_view(mesh);
}

std::unique_ptr<MeshReader> Input::reader(const SimplifyOptions& options, Access access,
                                          const AttributeRequest& wish,
                                          const ReaderMemory& memory) {
  std::unique_ptr<MeshReader> reader =
      mesh_ != nullptr ? open_view(job_, *mesh_, memory, wish)
      : source_ != nullptr
          ? open_reader(job_, std::move(source_), options.from, access, memory, wish)
          : join_files(job_, names_, options.from, memory, wish);
  if (!options.crop) return reader;
  Box box;
  box.add((*options.crop)[0]);
  box.add((*options.crop)[1]);
  return crop_to(box, std::move(reader));
}

InputProbe Input::probe(const SimplifyOptions& options, Access access,
                        const AttributeRequest& wish) {
  InputProbe probe = mesh_ != nullptr     ? look_at_view(*mesh_, wish)
                     : source_ != nullptr ? probe_input(job_, *source_, options.from, access, wish)
                                          : look_at_files(job_, names_, options.from, wish);
  if (options.crop) probe.facts.faces.reset();
  return probe;
}

void refuse_without_faces(const MeshReader& reader, const std::string& purpose) {
  const InputFacts& facts = reader.facts();
  const std::uint64_t points = facts.vertices.value_or(0) + facts.points;
  if (points == 0 || facts.faces != std::uint64_t{0})
    throw Error(ErrorKind::bad_input,
                "'" + reader.name() + "' has no face that could be " + purpose);
  throw Error(
      ErrorKind::bad_input,
      "'" + reader.name() + "' has " + grouped(points) + (points == 1 ? " point" : " points") +
          " and no faces; make a surface of a point cloud first, by Poisson reconstruction say");
}

}  // namespace winnow
