// The map as a file: a NumPy array beside the output.
#include "support/attributes.hpp"
#include "support/budget.hpp"
#include "support/mapped.hpp"
#include "support/shape_files.hpp"
#include "support/simplified.hpp"
#include "support/stl_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace winnow::test {

namespace {

// The numbers of an array that numpy.save() could have written.
VertexMap read_npy(const std::string& path) {
  const std::string bytes = bytes_of_file(path);
  REQUIRE(bytes.size() >= 128);
  CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  CHECK((10 + length) % 64 == 0);
  CHECK(bytes[9 + length] == '\n');
  const std::string header = bytes.substr(10, length);
  VertexMap map((bytes.size() - 10 - length) / sizeof(std::int64_t));
  CHECK(header.starts_with("{'descr': '<i8', 'fortran_order': False, 'shape': (" +
                           std::to_string(map.size()) + ",), }"));
  std::memcpy(map.data(), bytes.data() + 10 + length, map.size() * sizeof(std::int64_t));
  return map;
}

struct MapPlace {
  Directory directory;
  std::string input = directory.file("in.ply"), output = directory.file("out.ply"),
              map = directory.file("map.npy");

  // With the words, to out.ply and map.npy; gives the bytes of both.
  std::string run(const Words& words, bool pipe = false) {
    const Words files{"simplify", pipe ? "-" : input, "-o", output, "--map", map, "--force"};
    const Run run = run_winnow(files + words, {.in = pipe ? input : "/dev/null"});
    INFO(joined(words) << run.err);
    REQUIRE(run.code == 0);
    return bytes_of_file(output) + bytes_of_file(map);
  }
  Run refused(const Words& words) const {
    Run run = run_winnow(Words{"simplify", input} + words);
    CHECK(directory.names() == std::vector<std::string>{"in.ply"});
    return run;
  }
};

}  // namespace

TEST_CASE("a map in a file is what a map in memory is", "[map]") {
  MapPlace place;
  write_file(place.input, ply_of(turned(shapes::hills(60), 0.2)));
  place.run({"--faces", "500"});
  SimplifyOptions options;
  options.target = Target::faces(500);
  Context context;
  context.scratch = place.directory.path();
  VertexMap map;
  simplify(context, place.input, options, nullptr, &map);
  CHECK(read_npy(place.map) == map);
}

TEST_CASE("the same map for any threads and memory, files and pipes", "[map][same_bytes]") {
  MapPlace place;
  generate("scan", 150'000, place.input);
  for (const Words& words : {Words{"--faces", "3000"}, Words{"--faces", "5000", "--detail", "4"},
                             Words{"--cell", "0.02"}, Words{"--error", "0.2%"},
                             Words{"--ratio", "1%", "--weld", "0.0001"}}) {
    INFO(joined(words));
    const std::string right = place.run(words + Words{"--threads", "1"});
    CHECK((place.run(words + Words{"--threads", "3"}) == right));
    CHECK((place.run(words, true) == right));
    const Words little = words + Words{"--threads", "2"};
    enough_memory(
        Words{"simplify", place.input, "-o", place.output, "--map", place.map, "--force"} + little);
    CHECK((bytes_of_file(place.output) + bytes_of_file(place.map) == right));
  }
}

TEST_CASE("maps of several inputs follow each other", "[map]") {
  MapPlace place;
  const Shape first = as_stored(shapes::hills(30), Numbers::floats);
  Shape second = as_stored(shapes::plate(4, 0.5), Numbers::floats);
  for (Point& p : second.vertices) p[2] += 4;
  const std::string soup = place.directory.file("in.stl");
  write_file(place.input, ply_of(first));
  write_file(soup, binary_stl(triangles_of(second)));
  Shape all = first;
  all = joined(all, with_own_corners(second));
  all = joined(all, first);
  Context context;
  context.scratch = place.directory.path();
  SimplifyOptions options;
  options.map = place.map;
  for (const Target target : {Target::faces(300), Target::grid(20)}) {
    options.target = target;
    options.force = true;
    simplify(context, {place.input, soup, place.input}, place.output, options);
    const AttributedMesh written = read_attributed(place.output);
    Mesh mesh;
    mesh.positions = std::vector<float>(3 * written.positions.size());
    for (const auto& face : written.faces)
      mesh.faces.insert(mesh.faces.end(), face.begin(), face.end());
    check_map(all, mesh, read_npy(place.map));
  }
}

TEST_CASE("several results have a map each, which the report names", "[map]") {
  MapPlace place;
  const Shape shape = as_stored(turned(shapes::hills(60), 0.2), Numbers::floats);
  write_file(place.input, ply_of(shape));
  const std::string maps = place.directory.file("map-{faces}.npy");
  const std::string meshes = place.directory.file("out-{faces}.ply");
  const Words words{"simplify", place.input, "-o", meshes, "--map", maps, "--faces", "2k,500,100"};
  const auto report = winnow_ok(words + Words{"--json"}).json();
  SimplifyOptions options;
  options.target = Target::faces(2000);
  options.coarser = {Target::faces(500), Target::faces(100)};
  Context context;
  context.scratch = place.directory.path();
  std::vector<VertexMap> in_memory;
  const std::vector<Mesh> levels =
      simplify_levels(context, place.input, options, nullptr, &in_memory);
  REQUIRE(levels.size() == 3);
  REQUIRE(in_memory.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string file =
        place.directory.file("map-" + std::vector<std::string>{"2000", "500", "100"}[i] + ".npy");
    CHECK(report["levels"][i]["output"]["map"] == file);
    CHECK((read_npy(file) == in_memory[i]));
    check_map(shape, levels[i], in_memory[i]);
  }
  CHECK(report["output"]["map"] == report["levels"][0]["output"]["map"]);
  const Run shown = winnow_ok(words + Words{"--force"});
  CHECK(shown.out.find("map       " + place.directory.file("map-500.npy")) != std::string::npos);
  // One that cannot appear leaves none.
  for (const auto& entry : std::filesystem::directory_iterator(place.directory.path()))
    if (entry.path() != place.input) std::filesystem::remove(entry.path());
  for (const char* name : {"map-2000.npy", "map-100.npy", "out-500.ply"}) {
    const Run run =
        run_winnow(words, {.fault = "rename 1 " + std::to_string(EIO) + " " + std::string(name)});
    CHECK(run.code == 4);
    CHECK(place.directory.names() == std::vector<std::string>{"in.ply"});
  }
}

TEST_CASE("a map that cannot be is refused, and nothing is written", "[map]") {
  MapPlace place;
  write_file(place.input, ply_of(shapes::hills(10)));
  const std::string stl = place.directory.file("out.stl");
  const std::string glb = place.directory.file("out.glb");
  const auto check = [&](const Words& words, const std::string& message,
                         const std::string& faces = "50") {
    const Run run = place.refused(words + Words{"--faces", faces});
    INFO(joined(words));
    CHECK(run.code == 2);
    CHECK(run.err.find(message) != std::string::npos);
  };
  check({"-o", place.output, "--map", "-"}, "--map takes the name of a file, not '-'");
  check({"-o", place.output, "--map", place.output}, "the output and its --map need a name each");
  check({"-o", stl, "--map", place.map}, "(STL binary)");
  check({"-o", glb, "--map", place.map, "--compress", "meshopt"},
        "--map gives numbers of vertices");
  check({"-o", place.output, "--map", place.input}, "--force");
  const std::string several = place.directory.file("out-{faces}.ply");
  check({"-o", several, "--map", place.map},
        "several values of --faces need {faces} in the name of --map", "20,10");
  check({"-o", several, "--map", several}, "need a name each", "20,10");
}

}  // namespace winnow::test
