// A mesh that a program adds in batches gives the same bytes as the file of it.
#include <winnow/simplification.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/ply_file.hpp"
#include "support/program.hpp"
#include "support/stl_file.hpp"
#include "support/surfaces.hpp"

#include <map>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

struct Flat {
  std::vector<double> positions;
  std::vector<std::uint32_t> corners;
};

// A ball as vertices and faces, or with three vertices of its own for each face.
Flat flat(const std::vector<Triangle>& faces, bool shared) {
  Flat out;
  std::map<Point, std::uint32_t> numbers;
  for (const Triangle& face : faces) {
    for (const Point& corner : face) {
      const auto next = static_cast<std::uint32_t>(out.positions.size() / 3);
      const auto [at, is_new] = numbers.emplace(corner, next);
      if (is_new || !shared)
        out.positions.insert(out.positions.end(), corner.begin(), corner.end());
      out.corners.push_back(shared ? at->second : next);
    }
  }
  return out;
}

std::string ply_of(const Flat& mesh, PlyType type) {
  Polygons polygons;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
    polygons.vertices.push_back({mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]});
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3)
    polygons.faces.push_back({mesh.corners[i], mesh.corners[i + 1], mesh.corners[i + 2]});
  PlyStyle style;
  style.coordinate = {type, type, type};
  return ply_file(polygons, style);
}

template <typename Real>
std::vector<Real> as(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

// Hands `values` over in parts of whole `unit`s.
template <typename Value, typename Add>
void in_parts(Random& random, const std::vector<Value>& values, std::size_t unit, const Add& add) {
  std::size_t at = 0;
  for (const std::size_t part : random.parts(values.size() / unit, 700)) {
    add(std::span(values).subspan(at * unit, part * unit));
    at += part;
  }
}

std::vector<SimplifyOptions> several_ways() {
  std::vector<SimplifyOptions> all(4);
  all[0].target = Target::cell(0.1);
  all[1].target = Target::grid(30);
  all[2].target = Target::faces(500);
  all[3].target = Target::error(Distance::of_diagonal(0.005));
  for (SimplifyOptions& options : all) options.force = true;
  return all;
}

struct Place {
  Place() { context.scratch = directory.path(); }
  Directory directory;
  Context context;
};

std::string simplified_file(Place& place, const std::string& name, const std::string& content,
                            const SimplifyOptions& options) {
  write_file(place.directory.file(name), content);
  simplify(place.context, place.directory.file(name), place.directory.file("right.ply"), options);
  return bytes_of_file(place.directory.file("right.ply"));
}

}  // namespace

TEST_CASE("vertices and faces that are added give what the PLY of them gives") {
  Place place;
  Random random(710);
  const Flat mesh = flat(as_floats(ball(40, 0.1)), true);
  for (const SimplifyOptions& options : several_ways()) {
    for (const bool doubles : {false, true}) {
      const std::string right = simplified_file(
          place, "in.ply", ply_of(mesh, doubles ? PlyType::float64 : PlyType::float32), options);
      const std::string path = place.directory.file("out.ply");
      Simplification simplification(place.context, path, options);
      // Faces may come before their vertices.
      in_parts(random, mesh.corners, 3, [&](auto part) { simplification.add_faces(part); });
      if (doubles) {
        in_parts(random, mesh.positions, 3, [&](auto part) { simplification.add_vertices(part); });
      } else {
        in_parts(random, as<float>(mesh.positions), 3,
                 [&](std::span<const float> part) { simplification.add_vertices(part); });
      }
      const SimplifyReport report = simplification.finish();
      CHECK(report.input.faces == mesh.corners.size() / 3);
      CHECK(report.input.vertices == mesh.positions.size() / 3);
      CHECK(bytes_of_file(path) == right);
    }
  }
}

TEST_CASE("triangles that are added give what the file of them gives") {
  Place place;
  Random random(711);
  const std::vector<Triangle> faces = as_floats(ball(40, 0.1));
  const Flat own = flat(faces, false);
  for (const SimplifyOptions& options : several_ways()) {
    for (const bool doubles : {false, true}) {
      const std::string right =
          doubles ? simplified_file(place, "in.ply", ply_of(own, PlyType::float64), options)
                  : simplified_file(place, "in.stl", binary_stl(faces), options);
      const std::string path = place.directory.file("out.ply");
      Simplification simplification(place.context, path, options);
      if (doubles) {
        in_parts(random, own.positions, 9, [&](auto part) { simplification.add_triangles(part); });
      } else {
        in_parts(random, as<float>(own.positions), 9,
                 [&](std::span<const float> part) { simplification.add_triangles(part); });
      }
      CHECK(simplification.finish().input.faces == faces.size());
      CHECK(bytes_of_file(path) == right);
    }
  }
}

TEST_CASE("the same bytes of added batches with any memory and threads", "[same_bytes]") {
  Place place;
  // Larger than what the smallest budget keeps in memory.
  const std::vector<float> coordinates = as<float>(flat(ball(450, 0.1), false).positions);
  SimplifyOptions options;
  options.target = Target::faces(2000);
  options.force = true;
  std::vector<std::string> outputs;
  for (const auto& [memory, threads] : {std::pair{std::uint64_t{2} << 30, 1U},
                                        {std::uint64_t{48} << 20, 2U},
                                        {std::uint64_t{512} << 20, 4U}}) {
    place.context.memory = memory;
    place.context.threads = threads;
    const std::string path = place.directory.file("out.ply");
    Simplification simplification(place.context, path, options);
    simplification.add_triangles(std::span(coordinates));
    const SimplifyReport report = simplification.finish();
    CHECK((report.spilled_bytes > 0) == (memory < std::uint64_t{64} << 20));
    outputs.push_back(bytes_of_file(path));
  }
  CHECK(outputs[0] == outputs[1]);
  CHECK(outputs[0] == outputs[2]);
}

TEST_CASE("what cannot be one mesh is refused") {
  Place place;
  SimplifyOptions options;
  options.target = Target::faces(100);
  const std::string path = place.directory.file("out.ply");
  const std::vector<double> doubles(9);
  const std::vector<float> floats(9);
  const std::vector<std::uint32_t> corners(3);
  const auto refused = [&](const auto& first, const auto& second) {
    Simplification simplification(place.context, path, options);
    first(simplification);
    return error_of([&] { second(simplification); }).kind() == ErrorKind::usage;
  };
  const auto vertices = [&](Simplification& s) { s.add_vertices(std::span(doubles)); };
  const auto single_vertices = [&](Simplification& s) { s.add_vertices(std::span(floats)); };
  const auto triangles = [&](Simplification& s) { s.add_triangles(std::span(doubles)); };
  const auto faces = [&](Simplification& s) { s.add_faces(corners); };
  const auto nothing = [](Simplification&) {};
  CHECK(refused(vertices, single_vertices));
  CHECK(refused(vertices, triangles));
  CHECK(refused(triangles, faces));
  CHECK(refused(faces, triangles));
  CHECK(refused(nothing, [&](Simplification& s) { s.add_faces(std::span(corners).first(2)); }));
  CHECK(refused(nothing, [&](Simplification& s) { s.add_vertices(std::span(floats).first(4)); }));
  CHECK(refused(nothing, [&](Simplification& s) { s.add_triangles(std::span(floats).first(6)); }));
  CHECK(error_of([&] { Simplification(place.context, path, options).finish(); }).kind() ==
        ErrorKind::bad_input);
  CHECK(error_of([&] { Simplification(place.context, path, {}); }).kind() == ErrorKind::usage);
  write_file(path, "there is something");
  CHECK(error_of([&] { Simplification(place.context, path, options); }).kind() == ErrorKind::usage);
}

TEST_CASE("what is added and not finished leaves nothing, and cancelling is noticed") {
  Place place;
  SimplifyOptions options;
  options.target = Target::faces(100);
  const std::vector<float> floats(9 * 1000);
  {
    Simplification simplification(place.context, place.directory.file("out.ply"), options);
    simplification.add_triangles(std::span(floats));
  }
  CHECK(place.directory.names().empty());
  Simplification simplification(place.context, place.directory.file("out.ply"), options);
  place.context.cancel();
  CHECK(error_of([&] { simplification.add_triangles(std::span(floats)); }).kind() ==
        ErrorKind::cancelled);
}

}  // namespace winnow::test
