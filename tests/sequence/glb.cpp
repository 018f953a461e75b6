// One GLB that holds all frames: as a result, and as an input.
#include <winnow/sequence.hpp>

#include "support/glb_file.hpp"
#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

constexpr std::size_t frames = 9;

struct Parts {
  nlohmann::json json;
  std::string binary;
};

Parts parts_of(const std::string& name) {
  const std::string bytes = bytes_of_file(name);
  const std::uint32_t json_bytes = number_at(bytes, 12);
  return {nlohmann::json::parse(bytes.substr(20, json_bytes)), bytes.substr(28 + json_bytes)};
}

void write_glb(const std::string& name, const Parts& glb) {
  std::string json = glb.json.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t value) {
    std::string bytes(4, '\0');
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
  };
  write_file(name, "glTF" + word(2) + word(28 + json.size() + glb.binary.size()) +
                       word(json.size()) + "JSON" + json + word(glb.binary.size()) +
                       std::string("BIN\0", 4) + glb.binary);
}

SequenceReport simplify(const std::vector<std::string>& inputs, const std::string& output,
                        double ratio, SequenceOptions options = {}) {
  TestJob job;
  options.target = Target::ratio(ratio);
  options.force = true;
  return simplify_sequence(job.context, inputs, output, options);
}

// The numbers of all lines that begin so.
std::vector<double> numbers_of(const std::string& name, const std::string& begin) {
  std::vector<double> out;
  std::istringstream lines(bytes_of_file(name));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(begin)) continue;
    std::istringstream words(line.substr(begin.size()));
    for (double x = 0; words >> x;) out.push_back(x);
  }
  return out;
}

// Frames as files of their own, `own` from 0 on and `back` from 1 on, are the same meshes but for
// the order of vertices, which is the same in all frames.
void check_same_frames(const Directory& directory, std::size_t count) {
  const auto name = [&](const char* begin, std::size_t t) {
    return directory.file(begin + std::to_string(t) + ".obj");
  };
  std::vector<std::size_t> place;  // of each vertex of `back` among the own
  for (std::size_t t = 0; t < count; ++t) {
    const std::vector<double> own = numbers_of(name("own-", t), "v ");
    const std::vector<double> back = numbers_of(name("back-", t + 1), "v ");
    REQUIRE(own.size() == back.size());
    const auto off = [&](std::size_t v, std::size_t w) {
      double farthest = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        farthest = std::max(farthest, std::abs(back[3 * v + axis] - own[3 * w + axis]));
      return farthest;
    };
    for (std::size_t v = 0; 3 * v < back.size() && t == 0; ++v) {
      place.push_back(0);
      for (std::size_t w = 1; 3 * w < own.size(); ++w)
        if (off(v, w) < off(v, place[v])) place[v] = w;
    }
    double farthest = 0;
    for (std::size_t v = 0; v < place.size(); ++v) farthest = std::max(farthest, off(v, place[v]));
    CHECK(farthest < 1e-6);
    std::set<std::array<double, 3>> faces;
    const auto add = [&](const std::vector<double>& corners, const auto& number) {
      for (std::size_t f = 0; f < corners.size(); f += 3) {
        std::array face{number(corners[f]), number(corners[f + 1]), number(corners[f + 2])};
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.insert(face);
      }
      return faces.size();
    };
    const std::vector<double> corners = numbers_of(name("own-", t), "f ");
    CHECK(add(corners, [](double corner) { return corner; }) == corners.size() / 3);
    const auto moved = [&](double corner) {
      return static_cast<double>(place[static_cast<std::size_t>(corner) - 1] + 1);
    };
    CHECK(add(numbers_of(name("back-", t + 1), "f "), moved) == corners.size() / 3);
  }
}

Error error_with(const std::vector<std::string>& inputs, const std::string& output,
                 const SequenceOptions& options = {}) {
  return error_of([&] { (void)simplify(inputs, output, 0.5, options); });
}

}  // namespace

TEST_CASE("one GLB holds the frames that files of their own would hold") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {20}, frames);
  const SequenceReport report = simplify(names, directory.file("all.glb"), 0.2);
  CHECK(report.output.names == std::vector<std::string>{directory.file("all.glb")});
  CHECK(report.output.bytes == bytes_of_file(directory.file("all.glb")).size());
  (void)simplify(names, directory.file("own-{frame}.obj"), 0.2);
  // Back again, as frames from 1 on.
  const SequenceReport again =
      simplify({directory.file("all.glb")}, directory.file("back-{frame}.obj"), 1);
  CHECK(again.input.frames == frames);
  CHECK(again.input.faces == report.output.faces);
  check_same_frames(directory, frames);
}

TEST_CASE("a GLB plays one frame after the other, 24 a second") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {8}, frames);
  (void)simplify(names, directory.file("all.glb"), 0.5);
  const Parts glb = parts_of(directory.file("all.glb"));
  const auto& targets = glb.json["meshes"][0]["primitives"][0]["targets"];
  CHECK(targets.size() == frames - 1);
  const auto& sampler = glb.json["animations"][0]["samplers"][0];
  const auto& times = glb.json["accessors"][sampler["input"].get<std::size_t>()];
  CHECK(times["count"] == frames);
  CHECK(times["max"][0].get<float>() == (frames - 1) / 24.0F);
  const auto& weights = glb.json["accessors"][sampler["output"].get<std::size_t>()];
  CHECK(weights["count"] == frames * (frames - 1));
  CHECK(weights["sparse"]["count"] == frames - 1);
  // The size grows with the frames, not with their square: 1 and its place, and a time, for each.
  const auto& view = glb.json["bufferViews"].back();
  CHECK(view["byteLength"] == 4 * frames + 8 * (frames - 1));
}

TEST_CASE("the animations of a glTF come along as they are") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {20}, 3);
  (void)simplify(names, directory.file("made.glb"), 1);
  Parts glb = parts_of(directory.file("made.glb"));
  // Two clips with weights of their own: four times by two targets; one by splines.
  const std::array<float, 24> numbers{0,    0.5F,  1, 2.5F, 0,    0,    1,    0.25F,
                                      0.5F, 0.5F,  0, -1,   0.5F, 1,    0.1F, 0.2F,
                                      1,    0.75F, 0, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F};
  const std::size_t begin = glb.binary.size();
  glb.binary.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
  glb.json["buffers"][0]["byteLength"] = glb.binary.size();
  const std::size_t view = glb.json["bufferViews"].size();
  glb.json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", sizeof numbers}});
  const std::size_t accessor = glb.json["accessors"].size();
  const auto add = [&](std::size_t first, std::size_t count) {
    glb.json["accessors"].push_back({{"bufferView", view},
                                     {"byteOffset", 4 * first},
                                     {"componentType", 5126},
                                     {"count", count},
                                     {"type", "SCALAR"}});
  };
  add(0, 4);
  add(4, 8);
  add(12, 2);
  add(12, 12);
  const auto clip = [&](const char* name, const char* between, std::size_t first) {
    return nlohmann::json{
        {"name", name},
        {"samplers", {{{"input", first}, {"output", first + 1}, {"interpolation", between}}}},
        {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}};
  };
  glb.json["animations"] = {clip("nod \"twice\"", "STEP", accessor),
                            clip("bend", "CUBICSPLINE", accessor + 2)};
  write_glb(directory.file("clip.glb"), glb);

  const SequenceReport report =
      simplify({directory.file("clip.glb")}, directory.file("small.glb"), 0.2);
  CHECK(report.notes.empty());
  const Parts small = parts_of(directory.file("small.glb"));
  REQUIRE(small.json["animations"].size() == 2);
  CHECK(small.json["animations"][0]["name"] == "nod \"twice\"");
  CHECK(small.json["animations"][0]["samplers"][0]["interpolation"] == "STEP");
  CHECK(small.json["animations"][1]["samplers"][0]["interpolation"] == "CUBICSPLINE");
  // All numbers are there again: those of the two times of the second clip twice.
  const std::string tail = small.binary.substr(small.binary.size() - sizeof(float) * 26);
  CHECK(std::memcmp(tail.data(), numbers.data(), sizeof(float) * 14) == 0);
  CHECK(std::memcmp(tail.data() + sizeof(float) * 14, numbers.data() + 12, sizeof(float) * 12) ==
        0);
}

TEST_CASE("what cannot be one GLB, or frames of one, is refused with a way out") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {4}, 3);
  (void)simplify(names, directory.file("all.glb"), 1);
  const auto check = [&](const Error& error, ErrorKind kind, const std::string& part) {
    const std::string message = error.what();
    INFO(message);
    CHECK(error.kind() == kind);
    CHECK(message.find(part) != std::string::npos);
    CHECK_FALSE(exists(directory.file("out.glb")));
  };
  SequenceOptions options;
  options.per_frame = 0.1;
  check(error_with(names, directory.file("out.glb"), options), ErrorKind::usage, "{frame}");
  options = {};
  options.encoding.quantize = 12;
  check(error_with(names, directory.file("out.glb"), options), ErrorKind::usage, "quantize");
  options = {};
  options.encoding.compress = Compression::meshopt;
  check(error_with(names, directory.file("out.glb"), options), ErrorKind::usage, "compress");
  check(error_with({names[0]}, directory.file("out.glb")), ErrorKind::usage, "morph targets");

  Parts glb = parts_of(directory.file("all.glb"));
  auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const nlohmann::json targets = primitive["targets"];
  primitive.erase("targets");
  write_glb(directory.file("still.glb"), glb);
  check(error_with({directory.file("still.glb")}, directory.file("out.glb")), ErrorKind::bad_input,
        "no morph targets");
  primitive["targets"] = nlohmann::json::array({targets[0]});
  write_glb(directory.file("fewer.glb"), glb);
  check(error_with({directory.file("fewer.glb")}, directory.file("out.glb")), ErrorKind::bad_input,
        "6 weights for 3 times and 1 targets");
  primitive["targets"] = targets;
  glb.json["accessors"][targets[1]["POSITION"].get<std::size_t>()]["count"] = 3;
  write_glb(directory.file("short.glb"), glb);
  check(error_with({directory.file("short.glb")}, directory.file("out.glb")), ErrorKind::bad_input,
        "'POSITION' has 3 elements for 25 positions");
}

TEST_CASE("a GLB far from the origin keeps how its frames move") {
  const Directory directory;
  std::vector<std::string> names;
  const MovingSheet sheet{10};
  for (std::size_t t = 0; t < 4; ++t) {
    std::vector<Point> positions = sheet.positions(t);
    for (Point& p : positions) p = p + Point{431000, 5412000, 300};
    names.push_back(directory.file("f" + std::to_string(t) + ".obj"));
    std::ostringstream text;
    text.precision(17);
    for (const auto& [x, y, z] : positions) text << "v " << x << " " << y << " " << z << "\n";
    write_file(names.back(), text.str() + obj_of({}, sheet.faces()));
  }
  (void)simplify(names, directory.file("all.glb"), 0.3);
  (void)simplify(names, directory.file("own-{frame}.obj"), 0.3);
  (void)simplify({directory.file("all.glb")}, directory.file("back-{frame}.obj"), 1);
  check_same_frames(directory, 4);
}

}  // namespace winnow
