// glTF and GLB: every way to store triangles, and where nodes place them.
#include "support/files.hpp"
#include "support/gltf_file.hpp"
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>
#include <meshoptimizer.h>
#include <sys/resource.h>

namespace winnow {

using test::difference;
using test::faces_of;
using test::GltfBuilder;
using test::Json;

namespace {

test::Polygons triangles(test::Random& random, std::size_t vertices, std::size_t faces) {
  return test::as_floats(test::random_polygons(random, vertices, faces, 3));
}

// The faces of a file of this one mesh, placed by a node.
std::vector<test::SeenFace> placed(const Json& nodes) {
  GltfBuilder file = test::gltf_of({test::unit_square.vertices, {{0, 1, 2}, {0, 2, 3}}}, 5123);
  file.json["nodes"] = nodes;
  return faces_of(file.glb());
}

void check_corner(const test::Point& seen, const test::Point& wanted) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(seen[axis] == Approx(wanted[axis]).margin(1e-12));
}

}  // namespace

TEST_CASE("a glTF is the mesh that was written, as GLB, as JSON, from a pipe") {
  test::Random random(500);
  for (const int type : {5121, 5123, 5125}) {
    const std::size_t vertices = type == 5121 ? 200 : 20'000;
    const test::Polygons mesh = triangles(random, vertices, 15'000);
    const GltfBuilder file = test::gltf_of(mesh, type);
    for (const std::string& content : {file.glb(), file.gltf()}) {
      CHECK(difference(faces_of(content), as_triangles(mesh)) == "");
      CHECK(difference(test::faces_of_pipe(content), as_triangles(mesh)) == "");
    }
  }
}

TEST_CASE("strips, fans and triangles without indices of a glTF") {
  test::Random random(501);
  const test::Polygons points = triangles(random, 9, 1);
  const auto read = [&](int mode, const std::vector<std::uint64_t>& indices) {
    GltfBuilder file;
    Json primitive{{"attributes", {{"POSITION", file.positions(points.vertices)}}}, {"mode", mode}};
    if (!indices.empty()) primitive["indices"] = file.indices(indices, 5123);
    file.mesh(Json::array({primitive}));
    return faces_of(file.glb());
  };
  const auto faces = [&](const std::vector<std::vector<std::int64_t>>& polygons) {
    return test::as_triangles({points.vertices, polygons});
  };
  CHECK(difference(read(4, {}), faces({{0, 1, 2}, {3, 4, 5}, {6, 7, 8}})) == "");
  CHECK(difference(read(5, {0, 1, 2, 3, 4}), faces({{0, 1, 2}, {2, 1, 3}, {2, 3, 4}})) == "");
  CHECK(difference(read(5, {0, 1, 2, 2, 3}), faces({{0, 1, 2}})) == "");
  CHECK(difference(read(6, {4, 1, 2, 3}), faces({{4, 1, 2}, {4, 2, 3}})) == "");
  CHECK(difference(read(4, {0, 1, 2, 3, 4}), faces({{0, 1, 2}})) == "");
  CHECK(read(1, {0, 1}).empty());
  CHECK(read(4, {0, 1, 9})[0].status == FaceStatus::out_of_range);
}

TEST_CASE("an index of a glTF names no other primitive's vertex") {
  GltfBuilder file;
  const std::size_t first = file.positions(test::unit_square.vertices);
  const std::size_t second = file.positions(test::unit_square.vertices);
  const std::size_t indices = file.indices({0, 1, 4, 0, 1, 2}, 5125);
  Json primitives = Json::array();
  for (const std::size_t positions : {first, second, first})
    primitives.push_back({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  file.mesh(primitives);
  const std::vector<test::SeenFace> faces = faces_of(file.glb());
  REQUIRE(faces.size() == 6);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(faces[i].status == (i % 2 == 0 ? FaceStatus::out_of_range : FaceStatus::good));
}

TEST_CASE("positions of a glTF between other attributes, and changed by a sparse accessor") {
  test::Random random(502);
  const test::Polygons mesh = triangles(random, 20'000, 1000);
  GltfBuilder file;
  const std::size_t positions = file.positions(mesh.vertices, 32);
  test::Polygons changed = mesh;
  std::string indices;
  std::string values;
  for (std::uint32_t i = 5; i < 20'000; i += static_cast<std::uint32_t>(random.between(1, 3))) {
    changed.vertices[i] = {1.0 * i, 2, 3};
    test::put_number(indices, i);
    for (const double x : changed.vertices[i]) test::put_number(values, static_cast<float>(x));
  }
  const Json sparse{{"count", indices.size() / 4},
                    {"indices", {{"bufferView", file.view(indices)}, {"componentType", 5125}}},
                    {"values", {{"bufferView", file.view(values)}}}};
  const Json attributes{{"POSITION", positions}};
  file.mesh(Json::array(
      {{{"attributes", attributes}, {"indices", file.indices(corners_of(mesh), 5125)}}}));
  CHECK(difference(faces_of(file.glb()), as_triangles(mesh)) == "");
  file.json["accessors"][positions]["sparse"] = sparse;
  CHECK(difference(faces_of(file.glb()), as_triangles(changed)) == "");
  CHECK(difference(faces_of(file.gltf()), as_triangles(changed)) == "");
}

TEST_CASE("nodes of a glTF move, turn, stretch and mirror") {
  const auto moved = placed({{{"mesh", 0}, {"translation", {5e6, 0.125, -3}}}});
  CHECK(moved[0].corner[1] == test::Point{5000001, 0.125, -3});
  const auto scaled = placed({{{"mesh", 0}, {"scale", {2, 3, 4}}, {"translation", {1, 1, 1}}}});
  CHECK(scaled[0].corner[2] == test::Point{3, 4, 1});
  // A quarter turn around z, then moved by the parent.
  const double half = std::sqrt(0.5);
  const auto turned = placed({{{"children", {1}}, {"translation", {10, 0, 0}}},
                              {{"mesh", 0}, {"rotation", {0, 0, half, half}}}});
  check_corner(turned[0].corner[1], {10, 1, 0});
  check_corner(turned[0].corner[2], {9, 1, 0});
  const auto by_matrix =
      placed({{{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}}}});
  check_corner(by_matrix[0].corner[1], {10, 1, 0});
  const auto mirrored = placed({{{"mesh", 0}, {"scale", {-1, 1, 1}}}});
  CHECK(mirrored[0].corner[0] == test::Point{-1, 0, 0});
  CHECK(mirrored[0].corner[1] == test::Point{0, 0, 0});
  // Twice, and a node that is in no scene.
  CHECK(placed({{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}}).size() == 4);
  GltfBuilder file = test::gltf_of({test::unit_square.vertices, {{0, 1, 2}}});
  file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}};
  file.json["scenes"] = {{{"nodes", {1}}}};
  file.json["scene"] = 0;
  CHECK(faces_of(file.glb()).size() == 1);
}

TEST_CASE("quantized positions of a glTF") {
  GltfBuilder file;
  std::string bytes;
  for (const int x : {0, 65535, 0, 0, 0, 0, 32768, 65535, 0})
    test::put_number(bytes, static_cast<std::uint16_t>(x));
  file.add("accessors", {{"bufferView", file.view(bytes)},
                         {"componentType", 5123},
                         {"normalized", true},
                         {"count", 3},
                         {"type", "VEC3"}});
  file.mesh(Json::array({{{"attributes", {{"POSITION", 0}}}}}));
  file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto normalized = faces_of(file.glb());
  REQUIRE(normalized.size() == 1);
  CHECK(normalized[0].corner[0] == test::Point{0, 1, 0});
  CHECK(normalized[0].corner[2] == test::Point{32768.0 / 65535, 1, 0});
  file.json["accessors"][0]["normalized"] = false;
  CHECK(faces_of(file.glb())[0].corner[2] == test::Point{32768, 65535, 0});
  file.json["accessors"][0]["componentType"] = 5122;
  file.json["accessors"][0]["normalized"] = true;
  CHECK(faces_of(file.glb())[0].corner[0] == test::Point{0, -1.0 / 32767, 0});
}

TEST_CASE("buffers beside a glTF, but no others") {
  test::Random random(503);
  const test::Polygons mesh = triangles(random, 500, 700);
  const test::Directory directory;
  const GltfBuilder file = test::gltf_of(mesh);
  test::write_file(directory.file("the buffer.bin"), file.buffer);
  const auto read = [&](const std::string& uri) {
    test::write_file(directory.file("mesh.gltf"), file.gltf(uri));
    test::TestJob test;
    return faces_of(test.job, open_source(test.job, directory.file("mesh.gltf")));
  };
  CHECK(difference(read("the%20buffer.bin"), as_triangles(mesh)) == "");
  CHECK(difference(read("./the buffer.bin"), as_triangles(mesh)) == "");
  for (const std::string& uri :
       {std::string("../x.bin"), directory.file("the buffer.bin"), std::string("http://a.b/c.bin"),
        std::string("a/../../x"), std::string("%2e%2e/x"), std::string("missing.bin"),
        std::string("data:,x")}) {
    CAPTURE(uri);
    CHECK(test::error_of([&] { read(uri); }).kind() == ErrorKind::bad_input);
  }
  test::write_file(directory.file("the buffer.bin"), file.buffer.substr(1));
  CHECK(std::string(test::error_of([&] { read("the%20buffer.bin"); }).what()).find("cut short") !=
        std::string::npos);
}

TEST_CASE("more buffers beside a glTF than files may be open, whatever bytes they begin with") {
  test::Random random(505);
  const test::Polygons mesh = triangles(random, 50, 70);
  const test::Directory directory;
  const GltfBuilder file = test::gltf_of(mesh);
  const std::string like_gzip("\x1f\x8b\x08\x00", 4);
  constexpr std::size_t buffers = 60;
  auto json = nlohmann::json::parse(file.gltf("0.bin"));
  json["buffers"][0]["byteLength"] = file.buffer.size() + like_gzip.size();
  for (auto& view : json["bufferViews"]) view["byteOffset"] = view.value("byteOffset", 0) + 4;
  const nlohmann::json one = json;
  for (std::size_t k = 0; k < buffers; ++k) {
    const std::string name = std::to_string(k) + ".bin";
    test::write_file(directory.file(name), like_gzip + file.buffer);
    if (k == 0) continue;
    json["buffers"].push_back(one["buffers"][0]);
    json["buffers"][k]["uri"] = name;
    for (auto view : one["bufferViews"]) {
      view["buffer"] = k;
      json["bufferViews"].push_back(view);
    }
    for (auto accessor : one["accessors"]) {
      accessor["bufferView"] =
          accessor["bufferView"].get<std::size_t>() + k * one["bufferViews"].size();
      json["accessors"].push_back(accessor);
    }
    auto primitive = one["meshes"][0]["primitives"][0];
    const std::size_t shift = k * one["accessors"].size();
    primitive["indices"] = primitive["indices"].get<std::size_t>() + shift;
    for (auto& attribute : primitive["attributes"])
      attribute = attribute.get<std::size_t>() + shift;
    json["meshes"][0]["primitives"].push_back(primitive);
  }
  test::write_file(directory.file("mesh.gltf"), json.dump());
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
  const rlimit few{48, before.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &few) == 0);
  std::size_t faces = 0;
  std::string error;
  try {
    test::TestJob test;
    faces = faces_of(test.job, open_source(test.job, directory.file("mesh.gltf"))).size();
  } catch (const Error& failed) {
    error = failed.what();
  }
  ::setrlimit(RLIMIT_NOFILE, &before);
  CHECK(error == "");
  CHECK(faces == buffers * as_triangles(mesh).size());
}

TEST_CASE("buffer views packed by EXT_meshopt_compression") {
  test::Random random(504);
  const test::Polygons mesh = triangles(random, 3000, 5000);
  const std::vector<std::uint64_t> corners = corners_of(mesh);
  const std::vector<std::uint32_t> indices(corners.begin(), corners.end());
  std::vector<float> xyz;
  for (const auto& p : mesh.vertices) {
    for (const double x : p) xyz.push_back(static_cast<float>(x));
  }
  for (const char* mode : {"TRIANGLES", "INDICES"}) {
    GltfBuilder file;
    file.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(3000, 12));
    vertices.resize(
        meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), xyz.data(), 3000, 12));
    file.add("accessors", {{"bufferView", file.packed_view(vertices, "ATTRIBUTES", 3000, 12)},
                           {"componentType", 5126},
                           {"count", 3000},
                           {"type", "VEC3"}});
    const bool whole = std::string(mode) == "TRIANGLES";
    std::vector<unsigned char> faces(whole
                                         ? meshopt_encodeIndexBufferBound(indices.size(), 3000)
                                         : meshopt_encodeIndexSequenceBound(indices.size(), 3000));
    faces.resize(whole ? meshopt_encodeIndexBuffer(faces.data(), faces.size(), indices.data(),
                                                   indices.size())
                       : meshopt_encodeIndexSequence(faces.data(), faces.size(), indices.data(),
                                                     indices.size()));
    file.add("accessors", {{"bufferView", file.packed_view(faces, mode, indices.size(), 4)},
                           {"componentType", 5125},
                           {"count", indices.size()},
                           {"type", "SCALAR"}});
    file.mesh(Json::array({{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}));
    const std::vector<test::SeenFace> seen = faces_of(file.glb());
    REQUIRE(seen.size() == 5000);
    // Triangles may begin with another corner.
    const std::vector<test::SeenFace> wanted = as_triangles(mesh);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      auto corner = seen[i].corner;
      for (int turn = 0; turn < 2 && corner != wanted[i].corner; ++turn)
        std::rotate(corner.begin(), corner.begin() + 1, corner.end());
      REQUIRE(corner == wanted[i].corner);
    }
    // Damage is an error or other numbers.
    std::string glb = file.glb();
    for (int round = 0; round < 200; ++round) {
      std::string damaged = glb;
      damaged[damaged.size() - 1 - random.below(file.buffer.size())] =
          static_cast<char>(random.bits() >> 56);
      try {
        const std::size_t count = faces_of(damaged).size();
        CHECK(count == 5000);
      } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::bad_input);
      }
    }
  }
}

TEST_CASE("what of glTF is not read is said") {
  const auto refused = [](const std::function<void(Json&)>& change) {
    GltfBuilder file = test::gltf_of({test::unit_square.vertices, {{0, 1, 2}}});
    change(file.json);
    const Error error = test::error_of([&] { faces_of(file.glb()); });
    CHECK(error.kind() == ErrorKind::bad_input);
    return std::string(error.what());
  };
  CHECK(refused([](Json& json) {
          json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
        }).find("Draco") != std::string::npos);
  CHECK(refused([](Json& json) {
          json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
              {"bufferView", 0}};
        }).find("Draco") != std::string::npos);
  CHECK(refused([](Json& json) { json["extensionsRequired"] = {"X_strange"}; }).find("X_strange") !=
        std::string::npos);
  CHECK(refused([](Json& json) { json["asset"]["version"] = "1.0"; }).find("version 2") !=
        std::string::npos);
  test::TestJob test;
  GltfBuilder file = test::gltf_of({test::unit_square.vertices, {{0, 1, 2}}});
  file.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  CHECK(faces_of(test.job, std::make_unique<test::MemorySource>(file.glb())).size() == 1);
  REQUIRE(test.job.notes.size() == 1);
  CHECK(test.job.notes[0].find("1 primitive of") != std::string::npos);
}

}  // namespace winnow
