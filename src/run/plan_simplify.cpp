#include <winnow/simplify.hpp>

#include "io/arena.hpp"
#include "read/corner_streams.hpp"
#include "read/kept_faces.hpp"
#include "run/input.hpp"
#include "run/plan.hpp"
#include "run/simplify_options.hpp"

#include <algorithm>

namespace winnow {

namespace {

std::vector<std::string> passes_of(const InputOutlook& outlook, const SimplifyOptions& options) {
  std::vector<std::string> passes;
  if (outlook.copied_first) passes.emplace_back("copy the input to scratch");
  if (outlook.faces_kept) passes.emplace_back("keep the faces in scratch until the vertices are read");
  if (outlook.vertices_kept)
    passes.emplace_back("read the vertices into memory, or scratch where they do not fit");
  if (outlook.taken_in) passes.emplace_back("parse the input into memory, or scratch where it does not fit");
  const std::string positions =
      outlook.taken_in || outlook.facts.vertices ? "vertices" : "corners of all faces";
  if (options.grid) passes.push_back("measure the box of the " + positions);
  if (options.error || options.relative_error) passes.push_back("measure the box of the " + positions);
  if (options.faces || options.ratio) {
    if (!outlook.facts.faces && !outlook.taken_in && options.ratio) passes.emplace_back("count the faces");
    passes.push_back("find the box and a rough cell size from the " + positions);
    passes.push_back("sample the " + positions + " for the cell size");
  }
  const bool refine = cost_of(options) != Refine::none;
  passes.emplace_back(
      refine ? "cluster the faces, or weld equal positions where clustering would not spare the better half"
             : "cluster the faces");
  if ((options.faces || options.ratio) && !refine)
    passes.emplace_back("cluster them again, only if the sample misled by more than 10 %");
  if (refine) passes.emplace_back("collapse edges, tile by tile");
  passes.emplace_back("write the result");
  return passes;
}

// Scratch at the most where faces jump over more vertices than their share of memory has room for.
std::uint64_t worst_of_jumping(const InputOutlook& outlook, const MemoryPlan& plan) {
  const std::uint64_t record = outlook.facts.double_positions ? 3 * sizeof(double) : 3 * sizeof(float);
  const std::uint64_t looked_up = std::max(outlook.vertices_kept ? record : 0, outlook.vertex_bytes);
  if (outlook.facts.vertices.value_or(0) * looked_up <= plan.reader.vertices) return 0;
  // Of a pipe the faces wait, too.
  const std::uint64_t face = outlook.vertices_kept ? KeptFaces::bytes_a_face : 0;
  return outlook.facts.faces.value_or(0) * (CornerStreams::bytes_a_face(record) + face);
}

}  // namespace

SimplifyPlan plan_simplify(Context& context, const std::vector<std::string>& inputs,
                           const std::string& /*output*/, const SimplifyOptions& options) {
  check(options);
  Job job(context);
  job.budget.expect(MemoryPlan::smallest_for(job.threads, sums_quadrics(options)));
  Input input(job, inputs);
  const MemoryPlan plan =
      MemoryPlan::divide(context.memory, input.memory(), job.threads, sums_quadrics(options));
  const InputOutlook outlook = input.outlook(options);
  SimplifyPlan out;
  out.memory = plan.parts();
  out.smallest_memory = plan.smallest + input.memory();
  out.passes = passes_of(outlook, options);
  out.faces = outlook.facts.faces;
  out.vertices = outlook.facts.vertices;
  if (out.faces) {
    std::uint64_t kept = outlook.copied_first ? outlook.bytes.value_or(0) : 0;
    if (outlook.vertices_kept) kept += out.vertices.value_or(0) * (outlook.facts.double_positions ? 24 : 12);
    if (outlook.faces_kept) kept += *out.faces * KeptFaces::bytes_a_face;
    out.scratch_worst =
        worst_scratch(*out.faces, sums_quadrics(options)) + kept + worst_of_jumping(outlook, plan);
    out.scratch_expected = expected_scratch(*out.faces, plan, sums_quadrics(options)) + kept;
    // A rate measured once for one thread (bench/RESULTS.md), for want of knowing the machine.
    out.seconds_expected = static_cast<double>(*out.faces) / (2.2e7 * job.threads);
  }
  return out;
}

SimplifyPlan plan_simplify(Context& context, const std::string& input, const std::string& output,
                           const SimplifyOptions& options) {
  return plan_simplify(context, std::vector{input}, output, options);
}

}  // namespace winnow
