// What comes out: the same faces in every frame, exactly as many as asked for, each frame near its
// original.
#include <winnow/sequence.hpp>

#include "base/closest_point.hpp"
#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <variant>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

class SheetSource final : public FrameSource {
 public:
  SheetSource(MovingSheet sheet, std::size_t frames) : sheet_(sheet), frames_(frames) {}

  bool next(MeshView& frame) override {
    if (next_ == frames_) return false;
    positions_ = sheet_.positions(next_++);
    faces_ = sheet_.faces();
    frame = {positions_, faces_};
    return true;
  }

 private:
  MovingSheet sheet_;
  std::size_t frames_, next_ = 0;
  std::vector<Point> positions_;
  std::vector<std::array<std::uint32_t, 3>> faces_;
};

class Taken final : public FrameSink {
 public:
  void take(std::uint64_t frame, Mesh mesh) override {
    CHECK(frame == meshes.size());
    meshes.push_back(std::move(mesh));
  }
  std::vector<Mesh> meshes;
};

std::vector<Point> positions_of(const Mesh& mesh) {
  const auto& numbers = std::get<std::vector<double>>(mesh.positions);
  std::vector<Point> out;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    out.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return out;
}

double farthest_from(const std::vector<Point>& points, const std::vector<Point>& positions,
                     const std::vector<std::array<std::uint32_t, 3>>& faces) {
  double farthest = 0;
  for (const Point& p : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : faces) {
      const Point on = closest_point(p, {positions[a], positions[b], positions[c]});
      nearest = std::min(nearest, length(p - on));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace

TEST_CASE("all frames of a result have the same faces, as many as asked for") {
  const MovingSheet sheet{20};
  const std::size_t frames = GENERATE(1U, 2U, 7U, 20U);
  const double deformation = GENERATE(0.0, 1.0);
  const Quadrics quadrics = GENERATE(Quadrics::memoryless, Quadrics::accumulated);
  TestJob job;
  SheetSource source(sheet, frames);
  Taken taken;
  SequenceOptions options;
  options.target = Target::faces(120);
  options.deformation_weight = deformation;
  options.feature_weight = deformation / 2;
  options.quadrics = quadrics;
  const SequenceReport report = simplify_sequence(job.context, source, taken, options);
  CHECK(report.input.frames == frames);
  CHECK(report.input.faces == 800);
  CHECK(report.target_met);
  REQUIRE(taken.meshes.size() == frames);
  for (std::size_t t = 0; t < frames; ++t) {
    const Mesh& mesh = taken.meshes[t];
    // At most one collapse less.
    CHECK(mesh.face_count() <= 120);
    CHECK(mesh.face_count() >= 119);
    CHECK(mesh.faces == taken.meshes.front().faces);
    const std::vector<Point> positions = positions_of(mesh);
    // A fiftieth of the side; its waves are 0.3 high.
    CHECK(farthest_from(positions, sheet.positions(t), sheet.faces()) < 0.02);
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::size_t f = 0; f < mesh.faces.size(); f += 3)
      faces.push_back({mesh.faces[f], mesh.faces[f + 1], mesh.faces[f + 2]});
    CHECK(farthest_from(sheet.positions(t), positions, faces) < 0.03);
    // The sheet is a graph over the plane: no face has turned over.
    for (const auto& [a, b, c] : faces)
      CHECK(doubled_area({positions[a], positions[b], positions[c]})[2] > 0);
  }
}

TEST_CASE("each frame is fitted to its own original") {
  const MovingSheet sheet{40};
  constexpr std::size_t frames = 5;
  const auto squares = [&](std::uint64_t passes, Taken& taken) {
    TestJob job;
    SheetSource source(sheet, frames);
    SequenceOptions options;
    options.target = Target::faces(160);
    options.fit = passes;
    (void)simplify_sequence(job.context, source, taken, options);
    REQUIRE(taken.meshes.size() == frames);
    std::vector<double> sums;
    for (std::size_t t = 0; t < frames; ++t) {
      const Mesh& mesh = taken.meshes[t];
      const std::vector<Point> positions = positions_of(mesh);
      double sum = 0;
      for (const Point& p : sheet.positions(t)) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < mesh.faces.size(); f += 3) {
          const Point off =
              p - closest_point(p, {positions[mesh.faces[f]], positions[mesh.faces[f + 1]],
                                    positions[mesh.faces[f + 2]]});
          nearest = std::min(nearest, dot(off, off));
        }
        sum += nearest;
      }
      sums.push_back(sum);
    }
    return sums;
  };
  Taken plain, fitted;
  const std::vector<double> before = squares(0, plain);
  const std::vector<double> after = squares(2, fitted);
  for (std::size_t t = 0; t < frames; ++t) {
    CHECK(after[t] < 0.95 * before[t]);
    CHECK(fitted.meshes[t].faces == plain.meshes[t].faces);
  }
}

TEST_CASE("a share of the collapses may follow each frame's own cost") {
  const MovingSheet sheet{20};
  TestJob job;
  SheetSource source(sheet, 6);
  Taken taken;
  SequenceOptions options;
  options.target = Target::faces(120);
  options.per_frame = 0.2;
  const SequenceReport report = simplify_sequence(job.context, source, taken, options);
  // A fifth of 680 faces goes frame by frame.
  CHECK(report.collapses <= (680 - 136) / 2 + 40);
  CHECK(report.target_met);
  REQUIRE(taken.meshes.size() == 6);
  for (const Mesh& mesh : taken.meshes) {
    CHECK(mesh.face_count() <= 120);
    CHECK(mesh.face_count() >= 119);
  }
  CHECK(taken.meshes.front().faces != taken.meshes.back().faces);
}

TEST_CASE("a frame of which a face would turn over keeps an edge in all frames") {
  // Flat in both frames, so every edge is free; in the second one vertex is far beside its place,
  // so that hardly any collapse of its neighbours is legal there.
  const MovingSheet sheet{6};
  class Source final : public FrameSource {
   public:
    explicit Source(const MovingSheet& of) : faces_(of.faces()), positions_(of.positions(0)) {}
    bool next(MeshView& frame) override {
      if (count_ == 2) return false;
      for (Point& p : positions_) p[2] = 0;
      if (count_ == 1) positions_[24] = {0.55, 0.45, 0};
      ++count_;
      frame = {positions_, faces_};
      return true;
    }

   private:
    std::vector<std::array<std::uint32_t, 3>> faces_;
    std::vector<Point> positions_;
    int count_ = 0;
  };
  TestJob job;
  Source source(sheet);
  Taken taken;
  SequenceOptions options;
  options.target = Target::faces(10);
  (void)simplify_sequence(job.context, source, taken, options);
  REQUIRE(taken.meshes.size() == 2);
  for (const Mesh& mesh : taken.meshes) {
    const std::vector<Point> positions = positions_of(mesh);
    for (std::size_t f = 0; f < mesh.faces.size(); f += 3) {
      const Point normal = doubled_area(
          {positions[mesh.faces[f]], positions[mesh.faces[f + 1]], positions[mesh.faces[f + 2]]});
      CHECK(normal[2] > 0);
    }
  }
}

TEST_CASE("vertices at one place become one only if they are in every frame") {
  // Two squares side by side that do not share vertices; in the second frame of the moving one a
  // gap opens.
  const bool opens = GENERATE(false, true);
  class Source final : public FrameSource {
   public:
    explicit Source(bool gap) : opens_(gap) {}
    bool next(MeshView& frame) override {
      if (count_ == 2) return false;
      const double gap = opens_ && count_ == 1 ? 0.5 : 0;
      positions_ = {{0, 0, 0},       {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {1 + gap, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1 + gap, 1, 0}};
      ++count_;
      frame = {positions_, faces_};
      return true;
    }

   private:
    bool opens_;
    int count_ = 0;
    std::vector<Point> positions_;
    std::vector<std::array<std::uint32_t, 3>> faces_{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  };
  TestJob job;
  Source source(opens);
  Taken taken;
  SequenceOptions options;
  options.target = Target::ratio(1);
  const SequenceReport report = simplify_sequence(job.context, source, taken, options);
  CHECK(report.joined == (opens ? 0 : 2));
  CHECK(report.output.vertices == (opens ? 8 : 6));
  CHECK(report.output.faces == 4);
}

TEST_CASE("a sequence can be cancelled at any time and leaves no files") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {60}, 12);
  for (const int wait : {1, 20, 60, 150}) {
    TestJob job;
    const std::jthread cancelling = cancel_later(job.context, std::chrono::milliseconds(wait));
    SequenceOptions options;
    options.target = Target::faces(50);
    options.force = true;
    try {
      (void)simplify_sequence(job.context, names, directory.file("s-{frame}.ply"), options);
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::cancelled);
      CHECK_FALSE(exists(directory.file("s-0.ply")));
      CHECK(directory.names().size() == names.size());
      continue;
    }
    for (std::size_t t = 0; t < names.size(); ++t)
      std::filesystem::remove(directory.file("s-" + std::to_string(t) + ".ply"));
  }
}

}  // namespace winnow
