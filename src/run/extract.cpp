// A level of a progressive file as a mesh.
#include <winnow/error.hpp>
#include <winnow/options.hpp>
#include <winnow/progressive.hpp>

#include "base/text.hpp"
#include "io/arena.hpp"
#include "measure/result_surface.hpp"
#include "options/check_ranges.hpp"
#include "options/refuse_targets.hpp"
#include "progressive/shares.hpp"
#include "run/attributes.hpp"
#include "run/detail.hpp"
#include "run/played_mesh.hpp"
#include "run/refinement.hpp"
#include "run/result_sink.hpp"
#include "run/take_usage.hpp"
#include "run/write_mesh.hpp"
#include "stitch/unfolded_mesh.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace winnow {

namespace {

void check(const ExtractOptions& options) {
  if (options.target.kind() == Target::Kind::none)
    throw Error(ErrorKind::usage, "say how fine: `faces`, `ratio` or `error`");
  if (options.target.of_cells())
    throw Error(ErrorKind::usage, "only `faces`, `ratio` and `error` can be extracted");
  check_ranges(extract_options(), options);
}

// The attributes of the file that the output has.
struct Carried {
  std::vector<std::size_t> numbers;
  std::vector<Attribute> attributes;
  std::vector<std::string> dropped;
};

Carried carried_by(const MeshEncoder& encoder, const std::vector<Attribute>& all, bool normals) {
  Carried out;
  std::map<std::string, std::string> names;  // by why they are dropped
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string why = normals && names_normal(all[i])
                                ? "normals of the file, as `normals` computes those of the result:"
                                : encoder.attribute_refusal(all[i], all);
    if (why.empty()) {
      out.numbers.push_back(i);
      out.attributes.push_back(all[i]);
    } else {
      std::string& list = names[why];
      if (!list.empty()) list += ", ";
      list += all[i].name;
    }
  }
  for (const auto& [why, list] : names) out.dropped.emplace_back(why).append(" ").append(list);
  return out;
}

bool writes_normals(const ExtractOptions& options, const ProgressiveHeader& header,
                    const MeshEncoder& encoder, const std::vector<Attribute>& attributes) {
  if (options.normals) return true;
  if (carries_normals(attributes)) return encoder.normals_apart();
  return header.normals && std::none_of(attributes.begin(), attributes.end(), names_normal);
}

// The count of the coarsest level within an error.
std::uint64_t faces_within(const ProgressiveHeader& header, const std::string& name,
                           const Distance& wanted) {
  if (!facts_of(header.cost).bounds_error)
    throw Error(ErrorKind::usage, "'" + name + "' was made with `refine` " +
                                      facts_of(header.cost).name +
                                      ", whose costs are no distances: `error` goes with quadric "
                                      "alone");
  const double error = wanted.length(header.box.diagonal());
  if (error < header.position_error())
    throw Error(ErrorKind::usage, "positions in '" + name + "' have " +
                                      std::to_string(header.form.bits) +
                                      " bits and are off by up to " +
                                      shortest(header.position_error()) + ", more than `error`");
  return header.counts(header.chunks_within(error)).faces;
}

// The count that is asked for.
std::uint64_t target_of(const SplitPlayer& player, const std::string& name, const Target& target) {
  const std::uint64_t all = player.header().all().faces;
  const std::uint64_t base = player.header().base().faces;
  if (all == 0) throw Error(ErrorKind::bad_input, "'" + name + "' has no face");
  if (target.error()) return faces_within(player.header(), name, *target.error());
  const std::uint64_t wanted = std::min(*faces_wanted(target, all), all);
  if (wanted < base)
    throw Error(ErrorKind::usage, "the coarsest mesh in '" + name + "' has " + grouped(base) +
                                      " faces, and " + grouped(wanted) +
                                      " are asked for; `simplify` makes fewer of it");
  return wanted;
}

void expect(SplitPlayer& player, std::uint64_t faces, ScratchMemory* scratch) {
  if (scratch == nullptr) {
    player.expect(faces);
  } else {
    player.expect(faces, *scratch);
  }
}

void go_to(SplitPlayer& player, const std::string& name, std::uint64_t wanted,
           ScratchMemory* scratch) {
  expect(player, wanted, scratch);
  player.go_to(wanted);
  const std::uint64_t there = player.mesh().faces();
  if (there < wanted && player.cut_short())
    throw Error(ErrorKind::bad_input,
                "'" + name + "' is cut short: it ends after " + grouped(there) + " of its " +
                    grouped(player.header().all().faces) + " faces, and " + grouped(wanted) +
                    " are asked for; `faces` " + std::to_string(there) + " gives what is there");
}

// What flipped faces are found by: the same surface in so many times the faces at least, in more
// where the file has no more than are quickly played. The finer it is the more are found
// (bench/RESULTS.md).
constexpr std::uint64_t finer = 8, finest = 100, quickly_played = std::uint64_t{1} << 21;

std::uint64_t reference_faces(std::uint64_t faces, std::uint64_t all) {
  return std::min(all, std::max(finer * faces, std::min(finest * faces, quickly_played)));
}

// What extracting takes at the most when the file is open: the mesh that is played and what it was
// before it grew, the meshes made of it, a tile. Where the budget has less the mesh is in scratch.
// `stores`: the mesh is written from a copy that can be asked for anything.
std::uint64_t memory_for(const SplitPlayer& player, std::uint64_t faces, bool unfolds,
                         bool stores) {
  constexpr std::uint64_t tile = 48 * mebibyte;
  const ProgressiveHeader& header = player.header();
  const auto of = [&](std::uint64_t count) {
    const ProgressiveHeader::Counts counts = header.counts(header.chunks_for(count));
    const std::uint64_t stored =
        counts.vertices * (sizeof(IndexedVertex) + header.attributes.size() * sizeof(double)) +
        counts.faces * sizeof(FaceVertices);
    return SplitMesh::memory(counts.vertices, counts.faces, player.words().width()) +
           PlayedMesh::memory(counts.vertices, true) + (stores ? stored + stored / 4 : 0);
  };
  return tile + of(faces) + (unfolds ? of(reference_faces(faces, header.all().faces)) : 0);
}

// Turns flipped faces over. Plays the file further on.
void unfold(Job& job, SplitPlayer& player, StoredMesh& mesh, ScratchMemory* scratch) {
  const std::uint64_t faces = reference_faces(mesh.face_count, player.header().all().faces);
  expect(player, faces, scratch);
  player.go_to(faces);
  const StoredMesh reference = PlayedMesh(job, player, {}, false, scratch).store();
  RefineSettings settings;
  settings.decimation.single = !player.header().form.doubles;
  job.progress.begin("unfold", mesh.face_count, "faces");
  mesh.vertices =
      unfolded_vertices(job, mesh, reference, settings, refine_memory(job.budget.left()));
}

ExtractReport extract_in_arena(Job& job, const std::string& input, const MeshSink& output,
                               const ExtractOptions& options) {
  const Stopwatch watch;
  remove_stale_files(job.scratch.directory(), scratch_prefix);
  SimplifyOptions writing;
  writing.to = options.to;
  writing.encoding = options.encoding;
  writing.force = options.force;
  const ResultSinks sinks = open_sinks(job, output, writing);
  ResultSink& sink = *sinks.front();
  const MeshEncoder& encoder = sink.encoder();
  std::optional<ScratchMemory> pages;  // of the player, which goes before them
  SplitPlayer player(job, open_source(job, input), false);
  const ProgressiveHeader& header = player.header();
  job.progress.begin("extract", 0, "faces");
  ExtractReport report;
  const std::uint64_t all = header.all().faces;
  report.target_faces = target_of(player, input, options.target);
  // Whoever asks for an error gets the surface on which it was watched.
  const bool unfolds = !options.raw && !options.target.error() && report.target_faces < all;
  const bool stores = unfolds || !encoder.numbers_vertices() || encoder.needs_survey();
  if (memory_for(player, report.target_faces, unfolds, stores) > job.budget.left())
    pages.emplace(job, share::extracted::pages(job.budget.left()));
  ScratchMemory* const scratch = pages ? &*pages : nullptr;
  go_to(player, input, report.target_faces, scratch);
  const Carried carried = carried_by(encoder, header.attributes, options.normals);
  AttributeSelection choice;
  choice.carried = carried.attributes;
  choice.dropped = carried.dropped;
  note_dropped(job, choice);
  report.input = {input, header.all().faces, player.bytes_read()};
  report.seconds.read = watch.seconds();

  const bool normals = writes_normals(options, header, encoder, carried.attributes);
  std::optional<PlayedMesh> played(std::in_place, job, player, carried.numbers, normals, scratch);
  std::optional<StoredMesh> unfolded;
  std::optional<StoredOutput> stored;
  if (unfolds && played->face_count() < all) {
    unfolded.emplace(played->store());
    played.reset();
    unfold(job, player, *unfolded, scratch);
    stored.emplace(*unfolded);
  }
  const OutputMesh& mesh = stored ? static_cast<const OutputMesh&>(*stored) : *played;
  const bool doubles = writes_doubles(options.encoding, header.form.doubles);
  MeshShape shape =
      shape_of(job, mesh, encoder, normals, doubles, header.form.doubles, "extracted by winnow");
  shape.attributes = carried.attributes;
  shape.closed = encoder.needs_survey() && is_closed(job, mesh.stored());
  const std::uint64_t written = sink.write(mesh, shape);
  sink.finish();
  report.output = {sink.name(),    sink.format(), shape.faces,
                   shape.vertices, written,       encoder.position_error(shape)};
  report.attributes = {descriptions(choice), choice.dropped};
  take_usage(job, watch, report);
  return report;
}

}  // namespace

ExtractReport extract(Context& context, const std::string& input, const std::string& output,
                      const ExtractOptions& options) {
  check(options);
  Job job(context);
  return in_arena(job, [&] { return extract_in_arena(job, input, output, options); });
}

Mesh extract(Context& context, const std::string& input, const ExtractOptions& options,
             ExtractReport* report) {
  check(options);
  Job job(context);
  Mesh mesh;
  ExtractReport told =
      in_arena(job, [&] { return extract_in_arena(job, input, MeshSink(mesh), options); });
  if (report != nullptr) *report = std::move(told);
  return mesh;
}

}  // namespace winnow
