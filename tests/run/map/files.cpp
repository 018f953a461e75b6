// The map as a file: a NumPy array beside the output.
#include "support/attributes.hpp"
#include "support/budget.hpp"
#include "support/mapped.hpp"
#include "support/shape_files.hpp"
#include "support/simplified.hpp"
#include "support/stl_file.hpp"

#include <cstring>

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

TEST_CASE("a map that cannot be is refused, and nothing is written", "[map]") {
  MapPlace place;
  write_file(place.input, ply_of(shapes::hills(10)));
  const std::string stl = place.directory.file("out.stl");
  const std::string glb = place.directory.file("out.glb");
  const auto check = [&](const Words& words, const std::string& message) {
    const Run run = place.refused(words + Words{"--faces", "50"});
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
}

}  // namespace winnow::test
