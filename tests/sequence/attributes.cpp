// What vertices carry comes along in each frame.
#include <winnow/sequence.hpp>

#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

constexpr std::size_t frames = 4;

// Red tells the frame, and green where a vertex is.
double red_of(std::size_t frame) {
  return 0.2 + 0.2 * static_cast<double>(frame);
}

std::vector<std::string> write_colored_frames(const Directory& directory, std::size_t colored) {
  const MovingSheet sheet{12};
  std::vector<std::string> names;
  for (std::size_t t = 0; t < frames; ++t) {
    std::istringstream lines(obj_of(sheet.positions(t), sheet.faces()));
    std::string text;
    for (std::string line; std::getline(lines, line); text += line + "\n") {
      if (!line.starts_with("v ") || t >= colored) continue;
      const double x = std::stod(line.substr(2));
      line += " " + std::to_string(red_of(t)) + " " + std::to_string(x) + " 0.5";
    }
    names.push_back(directory.file("frame-" + std::to_string(t) + ".obj"));
    write_file(names.back(), text);
  }
  return names;
}

// Positions and colours.
std::vector<std::vector<double>> vertices_of(const std::string& name) {
  std::vector<std::vector<double>> out;
  std::istringstream lines(bytes_of_file(name));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("v ")) continue;
    std::istringstream words(line.substr(2));
    out.emplace_back();
    for (double x = 0; words >> x;) out.back().push_back(x);
  }
  return out;
}

void check_colors(const std::string& name, std::size_t frame) {
  const std::vector<std::vector<double>> vertices = vertices_of(name);
  REQUIRE_FALSE(vertices.empty());
  for (const std::vector<double>& vertex : vertices) {
    REQUIRE(vertex.size() == 6);
    CHECK(std::abs(vertex[3] - red_of(frame)) < 1e-3);
    CHECK(std::abs(vertex[4] - vertex[0]) < 0.2);
    CHECK(std::abs(vertex[5] - 0.5) < 1e-3);
  }
}

SequenceReport simplify(const std::vector<std::string>& inputs, const std::string& output,
                        double ratio, double per_frame = 0) {
  TestJob job;
  SequenceOptions options;
  options.target = Target::ratio(ratio);
  options.per_frame = per_frame;
  return simplify_sequence(job.context, inputs, output, options);
}

}  // namespace

TEST_CASE("colours come along in each frame") {
  const double per_frame = GENERATE(0.0, 0.3);
  const Directory directory;
  const std::vector<std::string> inputs = write_colored_frames(directory, frames);
  simplify(inputs, directory.file("small-{frame}.obj"), 0.2, per_frame);
  for (std::size_t t = 0; t < frames; ++t)
    check_colors(directory.file("small-" + std::to_string(t) + ".obj"), t);
}

TEST_CASE("colours come along in each target of a GLB, and back") {
  const Directory directory;
  const std::vector<std::string> inputs = write_colored_frames(directory, frames);
  const std::string glb = directory.file("small.glb");
  simplify(inputs, glb, 0.2);
  simplify({glb}, directory.file("back-{frame}.obj"), 1);
  for (std::size_t t = 0; t < frames; ++t)
    check_colors(directory.file("back-" + std::to_string(t + 1) + ".obj"), t);
}

TEST_CASE("what one frame lacks is not carried, and a note says so") {
  const Directory directory;
  const std::vector<std::string> inputs = write_colored_frames(directory, frames - 1);
  const SequenceReport report = simplify(inputs, directory.file("small-{frame}.obj"), 0.2);
  for (const std::vector<double>& vertex : vertices_of(directory.file("small-0.obj")))
    CHECK(vertex.size() == 3);
  CHECK(std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
    return note.starts_with("not carried: ") && note.find("frame-3.obj' lacks") != note.npos;
  }));
}

}  // namespace winnow
