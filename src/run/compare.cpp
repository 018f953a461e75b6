// How far two meshes lie apart: the simplified one in memory, the original streamed.
#include <winnow/compare.hpp>
#include <winnow/error.hpp>

#include "base/budget.hpp"
#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "base/viridis.hpp"
#include "io/arena.hpp"
#include "io/byte_sink.hpp"
#include "io/same_place.hpp"
#include "measure/distance_sums.hpp"
#include "measure/face_intake.hpp"
#include "measure/face_store.hpp"
#include "measure/forward_distances.hpp"
#include "measure/nearest_points.hpp"
#include "measure/surface_sampler.hpp"
#include "measure/surface_totals.hpp"
#include "measure/surface_tree.hpp"
#include "measure/welded_mesh.hpp"
#include "options/check_ranges.hpp"
#include "picture/camera.hpp"
#include "picture/side_by_side.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"
#include "read/mesh_reader.hpp"
#include "run/input.hpp"
#include "write/colored_ply.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace winnow {

namespace {

constexpr std::size_t batch_faces = 512;

// Blocks in flight, sums and recent vertices of each thread, Embree itself.
std::uint64_t fixed_memory(unsigned threads) {
  return 14 * mebibyte + threads * (2 * mebibyte + batches_in_flight(1) * batch_faces * 72);
}

std::uint64_t faces_in_flight(unsigned threads) {
  return batches_in_flight(threads) * batch_faces;
}

// The least of an original that is looked at in one tree: what is under way when it is full must
// still fit.
std::uint64_t smallest_chunk(unsigned threads) {
  return 64 * 1024 + 2 * faces_in_flight(threads);
}
constexpr std::uint64_t bytes_a_chunk_face = sizeof(NumberedFace) + SurfaceTree::bytes_a_face;

std::uint64_t bytes_a_simplified_face() {
  return sizeof(NumberedFace) + SurfaceTree::bytes_a_face + WeldedMesh::bytes_a_sealed_face +
         NearestPoints::bytes_a_face;
}

// What no ending tells is written all the same.
void check_ending(const char* option, const std::string& path,
                  const std::vector<std::string>& written) {
  std::string name = std::filesystem::path(path).filename().string();
  std::transform(name.begin(), name.end(), name.begin(), ascii_to_lower);
  if (name.find('.') == std::string::npos) return;
  std::string list;
  for (const std::string& ending : written) {
    if (name.ends_with(ending)) return;
    list += (list.empty() ? "" : " or ") + ending;
  }
  throw Error(ErrorKind::usage, std::string(option) + " writes " + list + ", not '" + path + "'");
}

class Comparison {
 public:
  Comparison(Job& job, const CompareOptions& options)
      : job_(job),
        options_(options),
        fixed_(job.budget.reserve(fixed_memory(job.threads), "working threads")) {}

  CompareReport run(const std::string& original, const std::string& simplified) {
    job_.budget.expect(0);
    read_simplified(simplified);
    WeldedMesh mesh(job_, simplified_->span());
    const std::size_t faces = simplified_->size();
    loose_places_ = mesh.vertices().size() > faces
                        ? mesh.more_bytes() + sizeof(double) * (mesh.vertices().size() - faces)
                        : 0;
    check_room(faces);
    report_.topology = mesh.topology();
    report_.topology.degenerate += report_.simplified.bad_faces.degenerate;
    report_.smallest_angles = mesh.smallest_angles();
    mesh.seal();
    const SurfaceTree tree(job_, simplified_->span());

    const double density = density_for(report_.simplified.area);
    NearestPoints points(job_, simplified_->span(), mesh.vertices(), SurfaceSampler(density));
    compare_with(original, tree, points);

    points.finish(report_, backward_);
    combine();
    if (picture_ != nullptr) draw_picture(tree, mesh, points.vertex_distances());
    if (sink_ != nullptr) {
      write_colored_ply(job_, mesh.vertices(), mesh.faces(), points.vertex_distances(),
                        report_.diagonal, *sink_);
    }
    // Nothing is left under a name unless all was written.
    for (const auto* sink : {&picture_, &sink_}) {
      if (*sink != nullptr) (*sink)->flush_and_sync();
    }
    if (picture_ != nullptr) picture_->finish();
    if (sink_ != nullptr) sink_->finish();
    return report_;
  }

 private:
  void read_simplified(const std::string& name) {
    if (!options_.picture.empty()) {
      picture_ = std::make_unique<ByteSink>(job_, options_.picture, options_.force);
      picture_->refuse_terminal();
      views_memory_ = job_.budget.reserve(SideBySide::memory(), "the picture");
      framing_ = std::make_unique<Framing>(options_.view, options_.viewer);
    }
    if (!options_.colored.empty()) {
      sink_ = std::make_unique<ByteSink>(job_, options_.colored, options_.force);
      sink_->refuse_terminal();
    }
    const std::unique_ptr<MeshReader> reader =
        open_reader(job_, open_source(job_, name), options_.from_simplified, Access::once,
                    {share::compare::reading_simplified(job_.budget.left()), batch_faces});
    report_.simplified.name = name;
    report_.simplified.format = reader->facts().format;
    if (reader->facts().faces) check_room(*reader->facts().faces);
    simplified_ =
        std::make_unique<FaceStore>(job_.budget, job_.budget.left() / sizeof(NumberedFace));
    FaceIntake intake(job_, reader->first_finite_position().value_or(Point{}));
    take_in(*reader, "read the simplified mesh", intake, [&](std::span<const NumberedFace> faces) {
      if (!simplified_->add(faces)) refuse(2 * simplified_->room());
    });
    intake.report(report_.simplified);
    check_size(intake.totals(), name);
    if (simplified_->size() == 0) refuse_without_faces(*reader, "compared");
    check_room(simplified_->size());
    simplified_->sort(job_);
  }

  // Beyond, products of areas leave the range of doubles.
  static void check_size(const SurfaceTotals& totals, const std::string& name) {
    constexpr double largest = 1e35;
    double most = 0;
    for (const Point& p : {totals.box().low, totals.box().high}) {
      for (const double x : p) most = std::max(most, std::abs(x));
    }
    if (totals.faces() > 0 && (most > largest || totals.box().diagonal() < 1 / largest)) {
      throw Error(ErrorKind::bad_input,
                  "'" + name + "' has coordinates up to " + shortest(most) + " and a diagonal of " +
                      shortest(totals.box().diagonal()) + "; both must be between 1e-35 and 1e35");
    }
  }

  // Everything that comes later, before it is too late to say so at once.
  void check_room(std::uint64_t faces) const {
    if (needed_for(faces) > job_.budget.total()) refuse(faces);
  }

  [[nodiscard]] std::uint64_t needed_for(std::uint64_t faces) const {
    return fixed_.bytes() + views_memory_.bytes() + loose_places_ +
           faces * bytes_a_simplified_face() + options_.samples * sizeof(double) +
           smallest_chunk(job_.threads) * bytes_a_chunk_face * 3 / 2 + 16 * mebibyte;
  }

  // `besides`: what a compressed original takes, which only its content tells.
  [[noreturn]] void refuse(std::uint64_t faces, std::uint64_t besides = 0) const {
    throw Error(ErrorKind::resources, "a memory budget of " + human_bytes(job_.budget.total()) +
                                          " is too small to compare with a mesh of " +
                                          grouped(faces) + " faces; enough is `memory` " +
                                          size_option((needed_for(faces) + besides + mebibyte - 1) /
                                                      mebibyte * mebibyte));
  }

  // A pass over all faces, of which `each` gets the good ones.
  template <typename Each>
  void take_in(MeshReader& reader, const char* stage, FaceIntake& intake, const Each& each) {
    job_.progress.begin(stage, reader.facts().faces.value_or(0), "faces");
    reader.begin_faces();
    for_each_face_batch(job_, reader,
                        [&](const FaceBatch& faces) {
                          const GoodFaces good(faces);
                          intake.add(good);
                          if (framing_ != nullptr) framing_->add(good.faces());
                          each(good.faces());
                        },
                        {});
    intake.finish();
  }

  [[nodiscard]] double density_for(double area) const {
    return area > 0 ? static_cast<double>(options_.samples) / area : 0;
  }

  void compare_with(const std::string& name, const SurfaceTree& tree, NearestPoints& points) {
    const std::uint64_t left = job_.budget.left();
    const std::uint64_t reading = share::compare::reading_original(left);
    const std::unique_ptr<MeshReader> reader =
        open_reader(job_, open_source(job_, name), options_.from_original, Access::repeatedly,
                    {reading, batch_faces});
    report_.original.name = name;
    report_.original.format = reader->facts().format;
    const std::uint64_t capacity =
        std::min(SurfaceTree::most_faces,
                 (job_.budget.left() - std::min(job_.budget.left(), reading)) / bytes_a_chunk_face);
    if (capacity < smallest_chunk(job_.threads))
      refuse(simplified_->size(), 2 * (left - job_.budget.left()));
    FaceStore chunk(job_.budget, capacity);

    // A first pass for what the samples hang on; of a large original it also takes a few faces
    // everywhere, as points whose distance is nearly known are passed over quickly by most of what
    // comes later.
    FaceIntake intake(job_, reader->first_finite_position().value_or(Point{}));
    const std::uint64_t known = reader->facts().faces.value_or(UINT64_MAX);
    const bool whole = known <= capacity;
    const std::uint64_t step =
        known == UINT64_MAX ? 64 : std::max<std::uint64_t>(2, 2 * (known / capacity + 1));
    take_in(*reader, "measure the original", intake, [&](std::span<const NumberedFace> faces) {
      if (!whole) take_some(faces, step, chunk);
    });
    intake.report(report_.original);
    check_size(intake.totals(), name);
    report_.diagonal = intake.totals().box().diagonal();
    if (report_.original.faces == 0) refuse_without_faces(*reader, "compared");
    if (framing_ != nullptr) views_ = std::make_unique<SideBySide>(framing_->frame());
    if (chunk.size() > 0) points.approach(chunk.span());
    chunk.clear();

    const SurfaceSampler sampler(density_for(report_.original.area));
    ForwardDistances forward(job_, tree, sampler);
    job_.progress.begin("compare", report_.original.faces, "faces");
    reader->begin_faces();
    const std::uint64_t in_flight = faces_in_flight(job_.threads);
    const auto full = [&] { return chunk.size() > 0 && chunk.size() + in_flight > chunk.room(); };
    for (bool more = true; more;) {
      job_.progress.check_cancelled();
      more = for_each_face_batch(
          job_, *reader,
          [&](const FaceBatch& faces) {
            const GoodFaces good(faces);
            forward.add(good.faces());
            if (views_ != nullptr) draw_original(good.faces());
            if (!chunk.add(good.faces())) refuse(simplified_->size());
          },
          full);
      points.approach(chunk.span());
      chunk.clear();
    }
    forward.finish(report_, forward_);
  }

  static void take_some(std::span<const NumberedFace> faces, std::uint64_t step, FaceStore& store) {
    for (const NumberedFace& face : faces) {
      // Where there is no more room, fewer are enough.
      if (mixed_hash(face.number) % step == 0 && !store.add({&face, 1})) return;
    }
  }

  void draw_original(std::span<const NumberedFace> faces) {
    for (const NumberedFace& face : faces) {
      job_.progress.check_cancelled();
      views_->original().draw(face.corner, face.number, {});
    }
  }

  // What is seen of the original is measured pixel by pixel, of the simplified mesh at its
  // vertices.
  void draw_picture(const SurfaceTree& tree, const WeldedMesh& mesh,
                    std::span<const double> squared) {
    job_.progress.begin("picture", 0, "pixels");
    views_->original().revalue(
        [&tree](const Point& point) {
          NearestFace nearest;
          tree.search(point, nearest);
          return std::sqrt(nearest.squared);
        },
        [this] { job_.progress.check_cancelled(); });
    const std::span<const NumberedFace> faces = simplified_->span();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      job_.progress.check_cancelled();
      const auto& [a, b, c] = mesh.faces()[f];
      views_->simplified().draw(
          faces[f].corner, f,
          {std::sqrt(squared[a]), std::sqrt(squared[b]), std::sqrt(squared[c])});
    }
    const double rms = std::max(report_.forward.rms, report_.backward.rms);
    views_->write_png(*picture_, last_color_at(rms, report_.diagonal), report_.diagonal);
  }

  void combine() {
    const Distances& f = report_.forward;
    const Distances& b = report_.backward;
    report_.symmetric = {(f.mean + b.mean) / 2, std::sqrt((f.rms * f.rms + b.rms * b.rms) / 2),
                         std::max(f.max, b.max)};
    report_.worst = f.max >= b.max ? forward_.worst() : backward_.worst();
    if (report_.original.area > 0) {
      report_.area_change =
          (report_.simplified.area - report_.original.area) / report_.original.area;
    }
    if (report_.original.volume && report_.simplified.volume && *report_.original.volume != 0) {
      report_.volume_change = (*report_.simplified.volume - *report_.original.volume) /
                              std::abs(*report_.original.volume);
    }
  }

  Job& job_;
  const CompareOptions& options_;
  Reservation fixed_;
  std::uint64_t loose_places_ = 0;  // what a mesh with more vertices than faces takes besides
  std::unique_ptr<ByteSink> sink_, picture_;
  Reservation views_memory_;
  std::unique_ptr<Framing> framing_;
  std::unique_ptr<SideBySide> views_;
  std::unique_ptr<FaceStore> simplified_;
  DistanceSums forward_, backward_;
  CompareReport report_;
};

}  // namespace

CompareReport compare(Context& context, const std::string& original, const std::string& simplified,
                      const CompareOptions& options) {
  if (original == "-" && simplified == "-")
    throw Error(ErrorKind::usage, "only one of the two meshes can come from standard input");
  check_ranges(compare_options(), options);
  check_ending("`colored`", options.colored, {".ply", ".ply.gz", ".ply.zst"});
  check_ending("`picture`", options.picture, {".png"});
  if (!options.colored.empty() && same_place(options.colored, options.picture))
    throw Error(ErrorKind::usage, "the coloured mesh and the picture need a name each");
  const Stopwatch watch;
  Job job(context);
  // So that the first refusal already names what is enough for a small mesh.
  job.budget.expect(options.samples * sizeof(double) +
                    smallest_chunk(job.threads) * bytes_a_chunk_face * 3 / 2 + 20 * mebibyte);
  CompareReport report =
      in_arena(job, [&] { return Comparison(job, options).run(original, simplified); });
  if (options.fail_above) {
    const double length = options.fail_above->length(report.diagonal);
    // The same surface twice has a distance all the same, of rounding.
    const double rounding = 1e-12 * report.diagonal;
    report.limit = {length, report.symmetric.rms > std::max(length, rounding)};
  }
  report.notes = job.notes;
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds = watch.seconds();
  return report;
}

}  // namespace winnow
