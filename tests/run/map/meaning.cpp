// Where each vertex of the input went.
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/mapped.hpp"
#include "support/shape_files.hpp"
#include "support/stl_file.hpp"

#include <cmath>

namespace winnow::test {

namespace {

// Simplifies a PLY of the shape, and an STL of the same faces, and checks both maps.
struct Mapped {
  Directory directory;
  Context context;
  Mesh output;
  VertexMap map;

  Mapped() {
    context.scratch = directory.path();
    context.threads = 2;
  }

  Shape run(const Shape& shape, const SimplifyOptions& options) {
    const Shape stored = as_stored(shape, Numbers::floats);
    const std::string input = directory.file("in.ply");
    write_file(input, ply_of(stored, Numbers::floats));
    output = simplify(context, input, options, nullptr, &map);
    check_map(stored, output, map);
    return stored;
  }
  Shape run_soup(const Shape& shape, const SimplifyOptions& options) {
    const Shape stored = with_own_corners(as_stored(shape, Numbers::floats));
    const std::string input = directory.file("in.stl");
    write_file(input, binary_stl(triangles_of(stored)));
    output = simplify(context, input, options, nullptr, &map);
    check_map(stored, output, map);
    return stored;
  }
};

SimplifyOptions options_for(Target target) {
  SimplifyOptions options;
  options.target = target;
  return options;
}

std::vector<SimplifyOptions> all_ways(std::uint64_t faces) {
  std::vector<SimplifyOptions> ways;
  for (const Refine cost : {Refine::quadric, Refine::volume, Refine::importance, Refine::none}) {
    ways.push_back(options_for(Target::faces(faces)));
    ways.back().refine = cost;
  }
  ways.push_back(options_for(Target::faces(faces)));
  ways.back().detail = 3;
  ways.push_back(options_for(Target::faces(faces)));
  ways.back().topology = Topology::free;
  ways.push_back(options_for(Target::faces(faces)));
  ways.back().boundary = Boundary::keep;
  ways.push_back(options_for(Target::error(Distance::of_diagonal(0.01))));
  ways.push_back(options_for(Target::ratio(1)));
  ways.push_back(options_for(Target::grid(30)));
  return ways;
}

void check_all_ways(const Shape& shape, std::uint64_t faces) {
  int number = 0;
  for (const SimplifyOptions& options : all_ways(faces)) {
    INFO("way " << number++);
    Mapped().run(shape, options);
    Mapped().run_soup(shape, options);
  }
}

}  // namespace

TEST_CASE("the map leads onto the result: closed, open, thin", "[map]") {
  check_all_ways(shapes::thin_shell(20, 0.05), 600);
  check_all_ways(shapes::hills(50), 500);
  check_all_ways(shapes::strip(100, 0.2), 40);
}

TEST_CASE("the map leads onto the result: faces around hubs, pages, crowds, soups", "[map][long]") {
  check_all_ways(shapes::capped_cylinder(700), 300);
  check_all_ways(shapes::book(50), 20);
  check_all_ways(shapes::crowd(5'000, 300), 1'000);
  check_all_ways(shapes::soup(3'000, 0.1), 600);
  check_all_ways(shapes::double_sided(17), 400);
}

TEST_CASE("the map leads onto the result through several rounds of tiles", "[map][long]") {
  const Shape shape = turned(shapes::hills(320), 0.3);
  Mapped().run(shape, options_for(Target::faces(3'000)));
  SimplifyOptions clustered = options_for(Target::faces(10'000));
  clustered.detail = 10;
  Mapped().run(shape, clustered);
  Mapped().run_soup(shape, options_for(Target::error(Distance::of_diagonal(0.0005))));
}

TEST_CASE("with cells alone the map is exactly the cell", "[map]") {
  constexpr double cell = 0.0625;
  Mapped mapped;
  const Shape input = mapped.run(shapes::hills(60), options_for(Target::cell(cell)));
  std::map<Point, std::int64_t> to;
  std::set<std::int64_t> taken;
  std::uint64_t vanished = 0;
  for (std::size_t i = 0; i < input.vertices.size(); ++i) {
    if (mapped.map[i] == -1) {
      ++vanished;
      continue;
    }
    Point place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = std::floor((input.vertices[i][axis] - input.vertices[0][axis]) / cell);
    const auto [found, is_new] = to.emplace(place, mapped.map[i]);
    CHECK(found->second == mapped.map[i]);
    if (is_new) CHECK(taken.insert(mapped.map[i]).second);
  }
  CHECK(vanished < input.vertices.size() / 10);
  CHECK(images_of(input, mapped.map) == faces_of_mesh(mapped.output));
}

TEST_CASE("vertices that no good face has went nowhere", "[map]") {
  Shape shape = shapes::hills(30);
  const auto first = static_cast<std::uint32_t>(shape.vertices.size());
  shape.vertices.push_back({0.5, 0.5, 0.02});
  shape.vertices.push_back({NAN, 0, 0});
  shape.vertices.push_back({0.25, 0.5, 0.01});
  shape.faces.push_back({0, 1, first + 1});
  shape.faces.push_back({first + 2, first + 2, 3});
  for (const SimplifyOptions& options : all_ways(300)) {
    Mapped mapped;
    mapped.run(shape, options);
    for (std::size_t i = 0; i < 3; ++i) CHECK(mapped.map[first + i] == -1);
  }
}

TEST_CASE("near vertices that were welded go the same way", "[map]") {
  SimplifyOptions options = options_for(Target::faces(400));
  options.weld = 1e-4;
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  const Shape shape = with_own_corners(as_stored(shapes::jittered_soup(20), Numbers::floats));
  const std::string input = directory.file("in.stl");
  write_file(input, binary_stl(triangles_of(shape)));
  VertexMap map;
  const Mesh output = simplify(context, input, options, nullptr, &map);
  REQUIRE(map.size() == 3 * shape.faces.size());
  std::set<std::int64_t> reached;
  for (const std::int64_t to : map) reached.insert(to);
  CHECK(reached.count(-1) == 0);
  CHECK(reached.size() == output.vertex_count());
  // Corners that are off by less than the distance.
  std::map<std::array<std::int64_t, 3>, std::int64_t> at;
  std::uint64_t parted = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    std::array<std::int64_t, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = std::llround(shape.vertices[i][axis] * 5'000 + 0.123);
    parted += at.emplace(place, map[i]).first->second == map[i] ? 0 : 1;
  }
  CHECK(parted == 0);
  CHECK(at.size() < map.size() / 4);
}

TEST_CASE("the map of a cropped mesh has all vertices", "[map]") {
  Mapped mapped;
  SimplifyOptions options = options_for(Target::ratio(0.2));
  options.crop = {{{0, 0, -1}, {0.5, 0.5, 1}}};
  const Shape stored = as_stored(shapes::hills(60), Numbers::floats);
  const std::string input = mapped.directory.file("in.ply");
  write_file(input, ply_of(stored, Numbers::floats));
  mapped.output = simplify(mapped.context, input, options, nullptr, &mapped.map);
  REQUIRE(mapped.map.size() == stored.vertices.size());
  std::set<std::int64_t> reached;
  for (std::size_t i = 0; i < mapped.map.size(); ++i) {
    const Point& p = stored.vertices[i];
    const bool inside = p[0] <= 0.5 && p[1] <= 0.5;
    if (inside) {
      reached.insert(mapped.map[i]);
    } else {
      CHECK(mapped.map[i] == -1);
    }
  }
  CHECK(reached.count(-1) == 0);
  CHECK(reached.size() == mapped.output.vertex_count());
}

}  // namespace winnow::test
