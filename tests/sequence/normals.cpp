// Normals of the input come along in each frame, as in simplify().
#include <winnow/sequence.hpp>

#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

constexpr std::size_t shaded_frames = 4;
constexpr double near_enough = 1e-5;

// Of all vertices in a frame: not that of the surface, which looks up.
Point normal_of(std::size_t frame) {
  const double angle = 0.3 + 0.4 * static_cast<double>(frame);
  return {std::cos(angle), std::sin(angle), 0};
}

// As text; the first frames have normals.
std::vector<std::string> write_ply_frames(const Directory& directory, std::size_t with_normals) {
  const MovingSheet sheet{12};
  std::vector<std::string> names;
  for (std::size_t t = 0; t < shaded_frames; ++t) {
    const bool normals = t < with_normals;
    const auto positions = sheet.positions(t);
    const auto faces = sheet.faces();
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex " << positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\n";
    if (normals) text << "property float nx\nproperty float ny\nproperty float nz\n";
    text << "element face " << faces.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Point& p : positions) {
      text << p[0] << " " << p[1] << " " << p[2];
      const Point normal = normal_of(t);
      if (normals) text << " " << normal[0] << " " << normal[1] << " " << normal[2];
      text << "\n";
    }
    for (const auto& [a, b, c] : faces) text << "3 " << a << " " << b << " " << c << "\n";
    names.push_back(directory.file("frame-" + std::to_string(t) + ".ply"));
    write_file(names.back(), text.str());
  }
  return names;
}

std::vector<Point> normals_in(const std::string& obj) {
  std::vector<Point> normals;
  std::istringstream lines(bytes_of_file(obj));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("vn ")) continue;
    std::istringstream words(line.substr(3));
    Point& normal = normals.emplace_back();
    words >> normal[0] >> normal[1] >> normal[2];
  }
  REQUIRE_FALSE(normals.empty());
  return normals;
}

void check_carried(const std::string& obj, std::size_t frame) {
  for (const Point& normal : normals_in(obj)) {
    INFO(obj << ": " << normal[0] << " " << normal[1] << " " << normal[2]);
    CHECK(length(normal - normal_of(frame)) < near_enough);
  }
}

void check_computed(const std::string& obj) {
  for (const Point& normal : normals_in(obj)) CHECK(normal[2] > 0.5);
}

SequenceReport simplify_shaded(const std::vector<std::string>& inputs, const std::string& output,
                               const SequenceOptions& asked = {}) {
  TestJob job;
  SequenceOptions options = asked;
  options.target = Target::ratio(0.3);
  return simplify_sequence(job.context, inputs, output, options);
}

}  // namespace

TEST_CASE("normals come along in each frame, or are computed if that is asked for") {
  const Directory directory;
  const std::vector<std::string> inputs = write_ply_frames(directory, shaded_frames);
  SequenceOptions options;
  options.per_frame = GENERATE(0.0, 0.3);
  simplify_shaded(inputs, directory.file("s-{frame}.obj"), options);
  options.normals = true;
  simplify_shaded(inputs, directory.file("n-{frame}.obj"), options);
  for (std::size_t t = 0; t < shaded_frames; ++t) {
    check_carried(directory.file("s-" + std::to_string(t) + ".obj"), t);
    check_computed(directory.file("n-" + std::to_string(t) + ".obj"));
  }
}

TEST_CASE("normals come along in each target of a GLB, and back") {
  const Directory directory;
  const std::string glb = directory.file("all.glb");
  simplify_shaded(write_ply_frames(directory, shaded_frames), glb);
  simplify_shaded({glb}, directory.file("back-{frame}.obj"));
  for (std::size_t t = 0; t < shaded_frames; ++t)
    check_carried(directory.file("back-" + std::to_string(t + 1) + ".obj"), t);
}

TEST_CASE("normals of a glTF whose targets move none are computed, and a note says so") {
  const Directory directory;
  const std::string glb = directory.file("all.glb");
  simplify_shaded(write_ply_frames(directory, shaded_frames), glb);
  std::string bytes = bytes_of_file(glb);
  const std::size_t targets = bytes.find("\"targets\"");
  REQUIRE(targets != std::string::npos);
  const std::size_t moved = bytes.find("\"NORMAL\"", targets);
  REQUIRE(moved != std::string::npos);
  bytes.replace(moved, 8, "\"_OTHER\"");
  write_file(glb, bytes);
  const SequenceReport report = simplify_shaded({glb}, directory.file("back-{frame}.obj"));
  for (std::size_t t = 0; t < shaded_frames; ++t)
    check_computed(directory.file("back-" + std::to_string(t + 1) + ".obj"));
  CHECK(std::any_of(report.notes.begin(), report.notes.end(), [](const std::string& note) {
    return note.find("normals that do not move with the targets") != note.npos;
  }));
}

TEST_CASE("normals that one frame lacks are computed in all, and a note says so") {
  const Directory directory;
  const SequenceReport report = simplify_shaded(write_ply_frames(directory, shaded_frames - 1),
                                                directory.file("s-{frame}.obj"));
  for (std::size_t t = 0; t < shaded_frames; ++t)
    check_computed(directory.file("s-" + std::to_string(t) + ".obj"));
  CHECK(std::any_of(report.notes.begin(), report.notes.end(), [](const std::string& note) {
    return note.find("nx") != note.npos && note.find("frame-3.ply' lacks") != note.npos;
  }));
}

}  // namespace winnow::test
