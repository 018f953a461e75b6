#include <winnow/simplify.hpp>

#include "cluster/near_faces.hpp"
#include "io/arena.hpp"
#include "io/block_sums.hpp"
#include "options/level_targets.hpp"
#include "read/corner_streams.hpp"
#include "read/indexed/buffered_faces.hpp"
#include "run/attributes.hpp"
#include "run/clustering.hpp"
#include "run/detail.hpp"
#include "run/input.hpp"
#include "run/plan.hpp"
#include "run/refinement.hpp"
#include "run/simplify_options.hpp"
#include "write/formats.hpp"

#include <algorithm>

namespace winnow {

namespace {

std::vector<std::string> passes_of(const InputProbe& probe, const SimplifyOptions& options) {
  std::vector<std::string> passes;
  if (probe.copied_first) passes.emplace_back("copy the input to scratch");
  if (probe.faces_buffered)
    passes.emplace_back("keep the faces in scratch until the vertices are read");
  if (probe.vertices_buffered)
    passes.emplace_back("read the vertices into memory, or scratch where they do not fit");
  if (probe.taken_in)
    passes.emplace_back("parse the input into memory, or scratch where it does not fit");
  if (std::any_of(probe.facts.choice.carried.begin(), probe.facts.choice.carried.end(),
                  [](const Attribute& attribute) { return !is_integer(attribute.type); }))
    passes.emplace_back("find the largest numbers that the vertices carry");
  const std::string positions =
      probe.taken_in || probe.facts.vertices ? "vertices" : "corners of all faces";
  if (welds(options)) {
    if (options.weld && options.weld->relative) passes.emplace_back("measure the box of the faces");
    passes.push_back("measure where most of the " + positions + " are");
    passes.emplace_back("gather the vertices of the faces, and join those near each other");
  }
  const bool part_of_box = options.target.error() && options.target.error()->relative;
  if (options.target.grid() || part_of_box) passes.emplace_back("measure the box of the faces");
  if (options.target.error() && !part_of_box)
    passes.push_back("measure the box of the " + positions);
  if (options.target.of_count()) {
    if ((welds(options) || (!probe.facts.faces && !probe.taken_in && options.target.ratio())))
      passes.emplace_back("count the faces");
    passes.push_back("find the box and a rough cell size from the " + positions);
    passes.push_back("sample the " + positions + " for the cell size");
  }
  const bool refine = cost_of(options) != Refine::none;
  passes.emplace_back(refine ? "cluster the faces, or weld equal positions where clustering would "
                               "not spare three quarters"
                             : "cluster the faces");
  if (options.target.of_count() && !refine)
    passes.emplace_back("cluster them again, only if the sample misled by more than 10 %");
  if (!options.map.empty()) passes.emplace_back("find where the vertices of the input went");
  if (fit_passes(options) > 0)
    passes.emplace_back("take samples of the faces, if they were clustered");
  if (refine) passes.emplace_back("collapse edges, tile by tile");
  if (fit_passes(options) > 0) {
    passes.push_back("fit the result to the samples" +
                     (fit_passes(options) == 1
                          ? std::string()
                          : ", " + std::to_string(fit_passes(options)) + " times"));
  }
  passes.emplace_back("count the edges of the result");
  passes.emplace_back("write the result");
  if (!options.coarser.empty()) {
    const std::size_t more = options.coarser.size();
    passes.push_back(std::string("collapse, ") + (fit_passes(options) > 0 ? "fit, " : "") +
                     "count and write " + std::to_string(more) +
                     (more == 1 ? " more time" : " more times") + ", each from the result before");
  }
  return passes;
}

// Bytes of what is needed of a vertex.
std::uint64_t vertex_record(const InputFacts& facts) {
  std::uint64_t bytes = 3 * (facts.double_positions ? sizeof(double) : sizeof(float));
  for (const Attribute& attribute : facts.choice.carried) bytes += size_of(attribute.type);
  return bytes;
}

// Scratch at the most where faces jump over more vertices than their share of memory has room for.
std::uint64_t worst_of_jumping(const InputProbe& probe, const MemoryPlan& plan) {
  const std::uint64_t record = vertex_record(probe.facts);
  const std::uint64_t looked_up =
      std::max(probe.vertices_buffered ? record : 0, probe.vertex_bytes);
  if (probe.facts.vertices.value_or(0) * looked_up <= plan.reader.vertices) return 0;
  // Of a pipe the faces wait, too.
  const std::uint64_t face = probe.vertices_buffered ? BufferedFaces::bytes_a_face : 0;
  return probe.facts.faces.value_or(0) * (CornerStreams::bytes_a_face(record) + face);
}

// Of the input: the bits of vertices that faces use, each in a record of its own, twice while runs
// are merged. Later less: where it went, twice, and the same of as many that are refined, before
// and after a round.
constexpr std::uint64_t map_bytes_a_vertex = 32;

// Rates of one thread in faces a second, measured once (bench/RESULTS.md), for want of knowing the
// machine.
constexpr double clustered_a_second = 2.2e7;
constexpr double welded_a_second = 2e6;
constexpr double collapsed_a_second = 3e5;
// Faces that are left, of which each vertex moves once.
constexpr double fitted_a_second = 3e5;
// Of a scan: the part of the faces that is near cells which clustering damages, and how many more
// faces the mesh of cells has when these are split.
constexpr double near_damage = 0.08;
constexpr double split_faces = 1.3;

// Of a coherent scan; at a tenth of its faces for a cell or grid. How far an error goes shows only
// later.
void foretell(const SimplifyOptions& options, const MemoryPlan& plan, const CellNeeds& needs,
              std::uint64_t memory, unsigned threads, SimplifyPlan& out) {
  if (options.target.error()) return;
  const auto faces = static_cast<double>(*out.faces);
  const std::uint64_t target =
      std::min(*out.faces, faces_wanted(options.target, *out.faces).value_or(*out.faces / 10));
  out.scratch_expected = expected_scratch(target, plan, needs);
  double seconds = faces / clustered_a_second;
  if (cost_of(options) != Refine::none) {
    Detail detail = detail_for(options, *out.faces, target);
    std::uint64_t near = 0;
    if (detail.welded) {
      seconds = faces / welded_a_second;
    } else {
      // They are read again, and those near damage clustered again.
      seconds *= 2;
      near = static_cast<std::uint64_t>(near_damage * faces) *
             NearFaces::bytes_a_face(needs.attributes);
      if (near <= plan.cluster.vertices / 2) near = 0;
      near += expected_scratch(detail.faces, plan, needs);
      detail.faces = static_cast<std::uint64_t>(split_faces * static_cast<double>(detail.faces));
    }
    if (detail.faces > target)
      seconds += static_cast<double>(detail.faces - target) / collapsed_a_second;
    seconds += fit_passes(options) * static_cast<double>(target) / fitted_a_second;
    // The input is read once more for its samples.
    if (fit_passes(options) > 0 && !detail.welded) seconds += faces / clustered_a_second;
    out.scratch_expected =
        std::max(near, refining_scratch(detail.faces, refine_memory(memory), needs));
  }
  out.seconds_expected = seconds / threads;
}

constexpr const char* shows_later = "whether faces are clustered first shows once they are counted";

}  // namespace

SimplifyPlan plan_simplify(Context& context, const std::vector<std::string>& inputs,
                           const std::string& output, const SimplifyOptions& options) {
  check(options);
  Job job(context);
  job.budget.expect(MemoryPlan::smallest_for(job.threads, needs_of(options)));
  Input input(job, inputs);
  const std::unique_ptr<MeshEncoder> encoder = make_encoder(options.to, output, options.encoding);
  const InputProbe probe =
      input.probe(options, access_for(options, !options.map.empty()), wish_for(options, *encoder));
  const CellNeeds needs = needs_of(options, probe.facts.choice);
  const MemoryPlan plan = MemoryPlan::divide(context.memory, input.memory(), job.threads, needs);
  SimplifyPlan out;
  out.inputs = inputs;
  out.output = output;
  out.input_format = probe.facts.format;
  out.outputs = output_names(output, options);
  out.maps = map_names(options);
  out.output_format = format_written(options.to, output, options.encoding);
  out.memory = plan.parts();
  out.smallest_memory = plan.smallest + input.memory();
  out.passes = passes_of(probe, options);
  out.faces = probe.facts.faces;
  out.vertices = probe.facts.vertices;
  out.clustered_reason = shows_later;
  if (cost_of(options) == Refine::none) {
    out.clustered = true;
    out.clustered_reason = clustering_alone;
  }
  if (out.faces) {
    std::uint64_t kept = probe.copied_first ? probe.bytes.value_or(0) : 0;
    if (probe.vertices_buffered) kept += out.vertices.value_or(0) * vertex_record(probe.facts);
    if (probe.faces_buffered) kept += *out.faces * BufferedFaces::bytes_a_face;
    out.scratch_worst = BlockSums::with_sums(worst_scratch(*out.faces, needs) + kept +
                                             worst_of_jumping(probe, plan));
    if (cost_of(options) != Refine::none) {
      const auto target = faces_wanted(options.target, *out.faces);
      const Detail detail = target ? detail_for(options, *out.faces, std::min(*out.faces, *target))
                                   : detail_for_error(options, *out.faces);
      if (!detail.reason.empty()) out.clustered = !detail.welded;
      out.clustered_reason = detail.reason.empty() ? shows_later : detail.reason;
    }
    if (!options.map.empty()) {
      *out.scratch_worst += map_bytes_a_vertex * std::max(3 * *out.faces, out.vertices.value_or(0));
    }
    foretell(options, plan, needs, context.memory - input.memory(), job.threads, out);
    if (out.scratch_expected) *out.scratch_expected += kept;
  }
  return out;
}

SimplifyPlan plan_simplify(Context& context, const std::string& input, const std::string& output,
                           const SimplifyOptions& options) {
  return plan_simplify(context, std::vector{input}, output, options);
}

}  // namespace winnow
