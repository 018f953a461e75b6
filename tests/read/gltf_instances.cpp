// Instances of a glTF's mesh, the centre that CESIUM_RTC gives, and what of a glTF moves and is not
// carried.
#include "support/gltf_file.hpp"
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

const std::vector<Point> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// One triangle.
GltfBuilder triangle() {
  GltfBuilder file;
  file.mesh(Json::array({{{"attributes", {{"POSITION", file.positions(corner)}}}}}));
  file.json["nodes"] = {{{"mesh", 0}, {"translation", {100, 0, 0}}}};
  file.json["scenes"] = {{{"nodes", {0}}}};
  return file;
}

void set_instances(GltfBuilder& file, const Json& attributes) {
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
}

std::string refusal(const GltfBuilder& file) {
  const Error error = error_of([&] { faces_of(file.glb()); });
  CHECK(error.kind() == ErrorKind::bad_input);
  return error.what();
}

}  // namespace

TEST_CASE("every instance of a mesh is read, scaled, turned and moved within its node") {
  GltfBuilder file = triangle();
  const float half = static_cast<float>(std::sqrt(0.5));
  set_instances(
      file,
      {{"TRANSLATION", file.positions({{0, 0, 0}, {0, 5, 0}, {0, 0, 7}})},
       {"ROTATION", file.numbers<float>({0, 0, 0, 1, 0, 0, half, half, 0, 0, 0, 1}, 5126, "VEC4")},
       {"SCALE", file.positions({{1, 1, 1}, {2, 2, 2}, {-1, 1, 1}})}});
  for (const bool required : {false, true}) {
    if (required) file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const std::vector<SeenFace> faces = faces_of(file.glb());
    REQUIRE(faces.size() == 3);
    CHECK(faces[0].corner == std::array<Point, 3>{{{100, 0, 0}, {101, 0, 0}, {100, 1, 0}}});
    CHECK(faces[1].corner == std::array<Point, 3>{{{100, 5, 0}, {100, 7, 0}, {98, 5, 0}}});
    // Mirrored: the triangle is turned with it.
    CHECK(faces[2].corner == std::array<Point, 3>{{{99, 0, 7}, {100, 0, 7}, {100, 1, 7}}});
  }
}

TEST_CASE("instances have any of translation, rotation and scale, of any allowed type") {
  GltfBuilder moved = triangle();
  set_instances(moved, {{"TRANSLATION", moved.positions(std::vector<Point>(10'000, {3, 0, 0}))}});
  CHECK(faces_of(moved.glb()).size() == 10'000);
  CHECK(faces_of(moved.glb()).back().corner[1] == Point{104, 0, 0});
  GltfBuilder turned = triangle();
  set_instances(turned, {{"ROTATION", turned.numbers<std::int8_t>({0, 0, 127, 0, 0, 0, 90, 90},
                                                                  5120, "VEC4", true)}});
  const std::vector<SeenFace> faces = faces_of(turned.glb());
  REQUIRE(faces.size() == 2);
  CHECK(faces[0].corner[1] == Point{99, 0, 0});
  CHECK(faces[1].corner[1] == Point{100, 1, 0});
  GltfBuilder none = triangle();
  set_instances(none, Json::object());
  CHECK(faces_of(none.glb()).size() == 1);
}

TEST_CASE("instances that do not fit each other are an error") {
  GltfBuilder file = triangle();
  set_instances(file, {{"TRANSLATION", file.positions({{0, 0, 0}, {0, 5, 0}})},
                       {"SCALE", file.positions({{1, 1, 1}})}});
  CHECK_THAT(refusal(file), Catch::Contains("differ in length"));
  set_instances(file, {{"TRANSLATION", 99}});
  CHECK_THAT(refusal(file), Catch::Contains("names number 99"));
  set_instances(file, {{"ROTATION", 0}});
  CHECK_THAT(refusal(file), Catch::Contains("wrong type"));
  set_instances(file, {{"SCALE", 0}});
  file.json["accessors"][0]["count"] = 1'000'000;
  CHECK_THAT(refusal(file), Catch::Contains("behind the end"));
}

TEST_CASE("the centre that CESIUM_RTC gives is added, and told") {
  GltfBuilder file = triangle();
  file.json["extensions"]["CESIUM_RTC"]["center"] = {4'000'000.25, -20, 3};
  for (const bool nodes : {true, false}) {
    if (!nodes) {
      file.json.erase("nodes");
      file.json.erase("scenes");
    }
    file.json["extensionsRequired"] = {"CESIUM_RTC"};
    TestJob test;
    const auto faces = faces_of(test.job, std::make_unique<MemorySource>(file.glb()));
    REQUIRE(faces.size() == 1);
    CHECK(faces[0].corner[2] == Point{4'000'000.25 + (nodes ? 100 : 0), -19, 3});
    REQUIRE(test.job.notes.size() == 1);
    CHECK_THAT(test.job.notes[0],
               Catch::Contains("CESIUM_RTC") && Catch::Contains("4000000.25 -20 3"));
  }
}

TEST_CASE("morph targets, skins and animations of a glTF are named as not carried") {
  GltfBuilder file = triangle();
  const auto primitive = [&]() -> Json& { return file.json["meshes"][0]["primitives"][0]; };
  primitive()["targets"] = {{{"POSITION", 0}}};
  primitive()["attributes"]["JOINTS_0"] = 0;
  primitive()["attributes"]["WEIGHTS_0"] = 0;
  file.json["meshes"][0]["weights"] = {0.5};
  file.json["animations"] = {{{"channels", Json::array()}}};
  const Carried read = carried_by(std::make_unique<MemorySource>(file.glb()));
  CHECK(read.facts.offer.unread ==
        std::vector<std::string>{"skins", "morph targets and their weights", "animations"});
  primitive()["attributes"].erase("JOINTS_0");
  primitive()["attributes"].erase("WEIGHTS_0");
  file.json["skins"] = {{{"joints", {0}}}};
  CHECK(carried_by(std::make_unique<MemorySource>(file.glb())).facts.offer.unread ==
        std::vector<std::string>{"morph targets and their weights", "skins", "animations"});
}

}  // namespace winnow::test
