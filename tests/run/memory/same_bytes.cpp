// A mesh in memory becomes what the file of it becomes.
#include <winnow/mesh.hpp>
#include <winnow/simplification.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/mesh_arrays.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

constexpr const char* written_comment = "simplified by winnow";

std::vector<SimplifyOptions> memory_targets() {
  std::vector<SimplifyOptions> all(12);
  all[0].target = Target::cell(0.1);
  all[1].target = Target::grid(30);
  all[1].placement = Placement::mean;
  all[2].target = Target::faces(500);
  all[3].target = Target::faces(500);
  all[3].refine = Refine::none;
  all[4].target = Target::ratio(0.1);
  all[4].refine = Refine::volume;
  all[5].target = Target::faces(700);
  all[5].refine = Refine::importance;
  all[6].target = Target::error(Distance::of_diagonal(0.005));
  all[7].target = Target::faces(400);
  all[7].weld = 0.05;
  all[7].topology = Topology::free;
  all[8].target = Target::faces(300);
  all[8].crop = {{{-2, -2, 0}, {2, 2, 2}}};
  all[8].boundary = Boundary::keep;
  all[9].target = Target::faces(600);
  all[9].normals = true;
  all[9].attributes = {"heat"};
  all[10].target = Target::faces(600);
  all[10].detail = 2;
  all[10].attributes.emplace();
  all[10].encoding.positions = Positions::doubles;
  all[11].target = Target::grid(25);
  all[11].nodata = 70'000;
  all[11].encoding.positions = Positions::floats;
  for (SimplifyOptions& options : all) options.force = true;
  return all;
}

struct MemoryPlace {
  MemoryPlace() { context.scratch = directory.path(); }
  Directory directory;
  Context context;

  // What a file of `mesh` becomes.
  std::string by_file(const Mesh& mesh, const SimplifyOptions& options,
                      SimplifyReport* report = nullptr) {
    write_file(directory.file("in.ply"), ply_of_arrays(mesh));
    const SimplifyReport told =
        simplify(context, directory.file("in.ply"), directory.file("out.ply"), options);
    if (report != nullptr) *report = told;
    return bytes_of_file(directory.file("out.ply"));
  }
};

std::string as_written(const Mesh& mesh) {
  return ply_of_arrays(mesh, written_comment);
}

// The numbers of an attribute as a column of records that stand apart.
struct InterleavedVertex {
  float x, y, z;
  std::uint8_t red, green, blue;
  std::int32_t label;
  double heat;
};

}  // namespace

TEST_CASE("memory to memory gives what file to file gives", "[library][same_bytes]") {
  MemoryPlace place;
  for (const bool doubles : {false, true}) {
    for (const bool attributes : {false, true}) {
      const Mesh mesh = ball_arrays(40, doubles, attributes);
      int number = 0;
      for (SimplifyOptions options : memory_targets()) {
        if (!attributes && options.attributes) options.attributes.emplace();
        CAPTURE(doubles, attributes, number++);
        SimplifyReport by_file;
        SimplifyReport report;
        const std::string right = place.by_file(mesh, options, &by_file);
        const Mesh result = simplify(place.context, mesh.view(), options, &report);
        CHECK((as_written(result) == right));
        CHECK(report.input.faces == by_file.input.faces);
        CHECK(report.input.vertices == by_file.input.vertices);
        CHECK(report.output.faces == result.face_count());
        CHECK(report.output.vertices == result.vertex_count());
        CHECK(report.attributes.carried == by_file.attributes.carried);
        CHECK(report.notes == by_file.notes);
        CHECK(report.refine.collapses == by_file.refine.collapses);
      }
    }
  }
}

TEST_CASE("indices of any type and rows that stand apart make the same mesh", "[library]") {
  MemoryPlace place;
  SimplifyOptions options;
  options.target = Target::faces(500);
  const Mesh mesh = ball_arrays(40, false, true);
  const std::string right = as_written(simplify(place.context, mesh.view(), options));
  const auto with_indices = [&](auto index) {
    using Index = decltype(index);
    const std::vector<Index> faces(mesh.faces.begin(), mesh.faces.end());
    MeshView view = mesh.view();
    view.faces = faces;
    return as_written(simplify(place.context, view, options));
  };
  CHECK((with_indices(std::int32_t{}) == right));
  CHECK((with_indices(std::uint32_t{}) == right));
  CHECK((with_indices(std::int64_t{}) == right));
  CHECK((with_indices(std::uint64_t{}) == right));

  const auto& xyz = std::get<std::vector<float>>(mesh.positions);
  std::vector<InterleavedVertex> vertices(mesh.vertex_count());
  std::vector<std::array<std::uint32_t, 5>> apart(mesh.face_count());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto value = [&](std::size_t attribute) {
      return std::visit([&](const auto& values) { return static_cast<double>(values[i]); },
                        mesh.attributes[attribute].values);
    };
    vertices[i] = {xyz[3 * i],
                   xyz[3 * i + 1],
                   xyz[3 * i + 2],
                   static_cast<std::uint8_t>(value(0)),
                   static_cast<std::uint8_t>(value(1)),
                   static_cast<std::uint8_t>(value(2)),
                   static_cast<std::int32_t>(value(3)),
                   value(4)};
  }
  for (std::size_t i = 0; i < apart.size(); ++i)
    apart[i] = {mesh.faces[3 * i], mesh.faces[3 * i + 1], mesh.faces[3 * i + 2], 9'999'999, 0};
  const std::size_t stride = sizeof(InterleavedVertex);
  const std::uint64_t count = vertices.size();
  const InterleavedVertex& first = vertices.front();
  MeshView view;
  view.positions = {&first.x, count, stride};
  view.faces = {apart.front().data(), apart.size(), sizeof apart.front()};
  view.attributes = {{"red", {&first.red, count, stride}},
                     {"green", {&first.green, count, stride}},
                     {"blue", {&first.blue, count, stride}},
                     {"label", {&first.label, count, stride}},
                     {"heat", {&first.heat, count, stride}}};
  CHECK((as_written(simplify(place.context, view, options)) == right));

  std::vector<std::array<float, 3>> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
  view.positions = points;
  CHECK((as_written(simplify(place.context, view, options)) == right));
}

TEST_CASE("a mesh in memory of any memory and threads", "[library][same_bytes]") {
  MemoryPlace place;
  const Mesh mesh = ball_arrays(300, false, true);
  SimplifyOptions options;
  options.target = Target::faces(5'000);
  options.detail = 6;
  std::vector<std::string> results;
  for (const auto& [memory, threads] : {std::pair{std::uint64_t{1} << 30, 1U},
                                        {std::uint64_t{72} << 20, 2U},
                                        {std::uint64_t{256} << 20, 4U}}) {
    place.context.memory = memory;
    place.context.threads = threads;
    results.push_back(as_written(simplify(place.context, mesh.view(), options)));
  }
  CHECK((results[0] == results[1]));
  CHECK((results[0] == results[2]));
  CHECK((results[0] == place.by_file(mesh, [&] {
    SimplifyOptions forced = options;
    forced.force = true;
    return forced;
  }())));
  CHECK(place.directory.names() == std::vector<std::string>{"in.ply", "out.ply"});
}

TEST_CASE("from memory to a file and from a file to memory", "[library][same_bytes]") {
  MemoryPlace place;
  const Mesh mesh = ball_arrays(30, true, true);
  SimplifyOptions options;
  options.target = Target::faces(500);
  options.force = true;
  const std::string right = place.by_file(mesh, options);
  const std::string path = place.directory.file("from-memory.ply");
  const SimplifyReport written = simplify(place.context, mesh.view(), path, options);
  CHECK((bytes_of_file(path) == right));
  CHECK(written.output.name == path);
  SimplifyReport report;
  const std::string input = place.directory.file("in.ply");
  CHECK((as_written(simplify(place.context, input, options, &report)) == right));
  CHECK(report.input.names == std::vector<std::string>{input});
}

TEST_CASE("what is added in batches can become a mesh in memory", "[library][same_bytes]") {
  MemoryPlace place;
  const Mesh mesh = ball_arrays(40, false, false);
  SimplifyOptions options;
  options.target = Target::faces(500);
  options.force = true;
  const std::string right = place.by_file(mesh, options);
  Simplification simplification(place.context, options);
  simplification.add_vertices(std::get<std::vector<float>>(mesh.positions));
  simplification.add_faces(mesh.faces);
  CHECK(error_of([&] { simplification.finish(); }).kind() == ErrorKind::usage);
  SimplifyReport report;
  CHECK((as_written(simplification.finish_mesh(&report)) == right));
  CHECK(report.input.faces == mesh.face_count());

  Simplification to_file(place.context, place.directory.file("added.ply"), options);
  to_file.add_vertices(std::get<std::vector<float>>(mesh.positions));
  to_file.add_faces(mesh.faces);
  CHECK(error_of([&] { to_file.finish_mesh(); }).kind() == ErrorKind::usage);
  to_file.finish();
  CHECK((bytes_of_file(place.directory.file("added.ply")) == right));
}

}  // namespace winnow::test
