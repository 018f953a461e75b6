// Frame by frame as one comparison each; then all frames once more for the flicker.
#include <winnow/compare_sequence.hpp>
#include <winnow/error.hpp>

#include "base/closest_point.hpp"
#include "base/text.hpp"
#include "io/arena.hpp"
#include "measure/surface_tree.hpp"
#include "mesh/face_vertices.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"
#include "read/mesh_reader.hpp"
#include "run/frame_sheet.hpp"
#include "sequence/frame_names.hpp"
#include "write/append.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace winnow {

namespace {

// A point of a face: its corners, and how much each weighs.
struct Anchor {
  FaceVertices corners{};
  std::array<double, 3> weights{};
};

std::array<double, 3> weights_at(const Point& p, const Triangle& t) {
  const Point normal = doubled_area(t);
  const double square = dot(normal, normal);
  if (!(square > 0)) return {1, 0, 0};
  const auto part = [&](const Point& a, const Point& b) {
    return dot(doubled_area({p, a, b}), normal) / square;
  };
  const double first = part(t[1], t[2]);
  const double second = part(t[2], t[0]);
  return {first, second, 1 - first - second};
}

// The sum of squared second differences of some points over time.
class SecondDifferences {
 public:
  void add(std::vector<Point> points) {
    if (last_.size() == points.size() && before_.size() == points.size()) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Point second = points[i] - 2.0 * last_[i] + before_[i];
        sum_ += dot(second, second);
      }
      count_ += points.size();
    }
    before_ = std::exchange(last_, std::move(points));
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double rms() const { return std::sqrt(sum_ / static_cast<double>(count_)); }

 private:
  std::vector<Point> before_, last_;
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

class FlickerMeter {
 public:
  explicit FlickerMeter(Job& job) : job_(job) {}

  std::optional<SequenceComparison::Flicker> run(const std::vector<std::string>& originals,
                                                 const std::vector<std::string>& simplified) {
    if (originals.size() < 3) return {};
    job_.progress.begin("flicker", originals.size(), "frames");
    SecondDifferences of_original, of_simplified;
    std::size_t vertices = 0;
    for (std::size_t t = 0; t < originals.size(); ++t) {
      std::vector<Point> original, small;
      if (!read(originals[t], original) || !read(simplified[t], small)) return {};
      if (t == 0) {
        vertices = original.size();
        anchor(originals[t], original, small);
      }
      if (original.size() != vertices)
        throw Error(ErrorKind::bad_input, "'" + originals[t] + "' has " + grouped(original.size()) +
                                              " vertices, and '" + originals[0] + "' has " +
                                              grouped(vertices) +
                                              "; the frames of a sequence have the same vertices");
      if (small.size() != anchors_.size()) return {};
      std::vector<Point> carried;
      carried.reserve(anchors_.size());
      for (const auto& [corners, weights] : anchors_) {
        carried.push_back(weights[0] * original[corners[0]] + weights[1] * original[corners[1]] +
                          weights[2] * original[corners[2]]);
      }
      of_original.add(std::move(carried));
      of_simplified.add(std::move(small));
      job_.progress.advance(1);
    }
    if (of_simplified.count() == 0) return {};
    return SequenceComparison::Flicker{of_simplified.rms(), of_original.rms()};
  }

 private:
  std::unique_ptr<MeshReader> open(const std::string& name) {
    return open_reader(job_, open_source(job_, name), Format::automatic, Access::positions_first,
                       {job_.budget.left() / 4, 2048});
  }

  // False where vertices are not stored.
  bool read(const std::string& name, std::vector<Point>& positions) {
    const std::unique_ptr<MeshReader> reader = open(name);
    if (!reader->facts().vertices) return false;
    positions.resize(*reader->facts().vertices);
    // Three frames of either sequence are there at once.
    const std::uint64_t bytes = 4 * sizeof(Point) * positions.size();
    if (bytes > room_.bytes()) {
      room_.release();
      room_ = job_.budget.reserve(2 * bytes, "frames to measure the flicker of");
    }
    for_each_position_batch(job_, *reader, [&](const PositionView& view) {
      for (std::size_t i = 0; i < view.count; ++i)
        positions[view.first + i] = {view.axis[0][i], view.axis[1][i], view.axis[2][i]};
    });
    return true;
  }

  void anchor(const std::string& name, const std::vector<Point>& original,
              const std::vector<Point>& small) {
    const std::unique_ptr<MeshReader> reader = open(name);
    std::vector<FaceVertices> faces;
    for_each_face_batch_in_order(
        job_, *reader,
        [](const FaceBatch& batch, BatchBytes& bytes) {
          const GoodFaces good(batch);
          for (const NumberedFace& face : good.faces()) {
            for (const std::uint32_t* corner : batch.index)
              append(bytes, corner[face.number - batch.first]);
          }
        },
        [&](std::span<const std::byte> bytes) {
          const std::size_t before = faces.size();
          faces.resize(before + bytes.size() / sizeof(FaceVertices));
          std::memcpy(faces.data() + before, bytes.data(), bytes.size());
        });
    const Reservation reserved = job_.budget.reserve(
        faces.size() * (sizeof(FaceVertices) + sizeof(NumberedFace) + SurfaceTree::bytes_a_face),
        "the first frame, to measure the flicker");
    std::vector<NumberedFace> numbered;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto [a, b, c] = faces[f];
      numbered.push_back({{original[a], original[b], original[c]}, f});
    }
    const SurfaceTree tree(job_, numbered);
    NeighbourSearch search(tree);
    for (const Point& p : small) {
      NearestFace nearest;
      search.search(p, nearest);
      if (nearest.face == nullptr) continue;
      const Triangle& t = nearest.face->corner;
      anchors_.push_back({faces[nearest.face->number], weights_at(closest_point(p, t), t)});
    }
  }

  Job& job_;
  Reservation room_;
  std::vector<Anchor> anchors_;  // of the vertices of the simplified first frame
};

}  // namespace

SequenceComparison compare_sequence(Context& context, const std::vector<std::string>& originals,
                                    const std::vector<std::string>& simplified,
                                    std::uint64_t samples) {
  CompareOptions options;
  options.samples = samples;
  return compare_sequence(context, originals, simplified, options);
}

SequenceComparison compare_sequence(Context& context, const std::vector<std::string>& originals,
                                    const std::vector<std::string>& simplified,
                                    const CompareOptions& options) {
  if (originals.size() != simplified.size() || originals.empty())
    throw Error(ErrorKind::usage, "there are " + grouped(originals.size()) + " originals and " +
                                      grouped(simplified.size()) +
                                      " simplified frames; each original needs one");
  const Stopwatch watch;
  const std::vector<std::string> first = frame_names(originals).inputs;
  const std::vector<std::string> second = frame_names(simplified).inputs;
  SequenceComparison report;
  report.frames = first.size();
  CompareOptions each;
  each.samples = options.samples;
  if (!options.picture.empty()) {
    Job job(context);
    in_arena(job, [&] { write_frame_sheet(job, first, second, options); });
  }
  for (std::size_t t = 0; t < first.size(); ++t) {
    const CompareReport frame = compare(context, first[t], second[t], each);
    const double rms = frame.symmetric.rms;
    const double percent = percent_of(frame.diagonal, rms);
    report.rms.push_back(rms);
    report.flipped.push_back(frame.topology.flipped);
    report.mean_rms += rms / static_cast<double>(first.size());
    report.mean_rms_percent += percent / static_cast<double>(first.size());
    if (t == 0 || rms > report.worst_rms) {
      report.worst_rms = rms;
      report.worst_frame = t;
    }
    report.worst_rms_percent = std::max(report.worst_rms_percent, percent);
    report.most_flipped = std::max(report.most_flipped, frame.topology.flipped);
    report.degenerate += frame.topology.degenerate;
  }
  Job job(context);
  report.flicker = in_arena(job, [&] { return FlickerMeter(job).run(first, second); });
  report.peak_memory_bytes = peak_resident_bytes();
  report.seconds = watch.seconds();
  return report;
}

}  // namespace winnow
