// Every source gives every sink what the file of the same content becomes.
#include <winnow/simplification.hpp>
#include <winnow/stream.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/mesh_arrays.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <stdexcept>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// A part of the vertices of a mesh, or of its faces, as a batch of arrays of its own.
class MeshParts {
 public:
  MeshParts(const Mesh& mesh, std::uint64_t seed, bool faces_first)
      : mesh_(mesh), random_(seed), faces_first_(faces_first) {}

  bool operator()(MeshView& batch) {
    const bool more_vertices = vertex_ < mesh_.vertex_count();
    const bool more_faces = face_ < mesh_.face_count();
    if (!more_vertices && !more_faces) return false;
    part_ = {};
    if (faces_first_ && more_faces) {
      take_faces();
    } else {
      if (more_vertices) take_vertices();
      if (more_faces && random_.below(2) == 0) take_faces();
    }
    batch = part_.view();
    return true;
  }

 private:
  void take_vertices() {
    const std::uint64_t count =
        std::min<std::uint64_t>(random_.below(900), mesh_.vertex_count() - vertex_);
    const auto part = [&](const auto& numbers, std::uint64_t width) {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(width * vertex_);
      return std::decay_t<decltype(numbers)>(first,
                                             first + static_cast<std::ptrdiff_t>(width * count));
    };
    std::visit([&](const auto& xyz) { part_.positions = part(xyz, 3); }, mesh_.positions);
    for (const Mesh::Attribute& attribute : mesh_.attributes) {
      Mesh::Attribute& mine = part_.attributes.emplace_back();
      mine.name = attribute.name;
      std::visit([&](const auto& values) { mine.values = part(values, 1); }, attribute.values);
    }
    vertex_ += count;
  }
  void take_faces() {
    const std::uint64_t count =
        std::min<std::uint64_t>(random_.below(1'500), mesh_.face_count() - face_);
    const auto first = mesh_.faces.begin() + static_cast<std::ptrdiff_t>(3 * face_);
    part_.faces.assign(first, first + static_cast<std::ptrdiff_t>(3 * count));
    face_ += count;
  }

  const Mesh& mesh_;
  Random random_;
  bool faces_first_;
  Mesh part_;
  std::uint64_t vertex_ = 0, face_ = 0;
};

// Puts batches together again.
struct CollectedMesh {
  Mesh mesh;

  BatchSink sink() {
    return [this](const MeshView& batch) {
      CHECK((batch.positions.count() == 0) != (batch.faces.count() == 0));
      if (batch.positions.count() > 0) CHECK(mesh.faces.empty());
      const auto append = [](auto& numbers, const auto& rows, std::size_t width) {
        using Number = typename std::decay_t<decltype(numbers)>::value_type;
        const auto* first = static_cast<const Number*>(rows.data());
        numbers.insert(numbers.end(), first, first + width * rows.count());
      };
      if (batch.positions.count() > 0 && mesh.vertex_count() == 0) {
        if (batch.positions.type() == NumberType::float64) mesh.positions = std::vector<double>();
        for (const MeshView::Attribute& attribute : batch.attributes)
          mesh.attributes.push_back({attribute.name, empty_of(attribute.values.type())});
      }
      std::visit([&](auto& xyz) { append(xyz, batch.positions, 3); }, mesh.positions);
      for (std::size_t i = 0; i < batch.attributes.size() && batch.positions.count() > 0; ++i) {
        CHECK(batch.attributes[i].name == mesh.attributes[i].name);
        std::visit([&](auto& values) { append(values, batch.attributes[i].values, 1); },
                   mesh.attributes[i].values);
      }
      append(mesh.faces, batch.faces, 3);
    };
  }

 private:
  static decltype(Mesh::Attribute::values) empty_of(NumberType type) {
    switch (type) {
      case NumberType::uint8:
        return std::vector<std::uint8_t>();
      case NumberType::int32:
        return std::vector<std::int32_t>();
      case NumberType::float64:
        return std::vector<double>();
      default:
        return std::vector<float>();
    }
  }
};

std::vector<SimplifyOptions> stream_targets() {
  std::vector<SimplifyOptions> all(6);
  all[0].target = Target::cell(0.1);
  all[1].target = Target::faces(500);
  all[2].target = Target::ratio(0.1);
  all[2].refine = Refine::volume;
  all[3].target = Target::faces(700);
  all[3].refine = Refine::importance;
  all[4].target = Target::error(Distance::of_diagonal(0.005));
  all[5].target = Target::faces(400);
  all[5].weld = 0.05;
  all[5].normals = true;
  for (SimplifyOptions& options : all) options.force = true;
  return all;
}

}  // namespace

TEST_CASE("every source gives every sink the same mesh and map", "[library][same_bytes]") {
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  for (const bool doubles : {false, true}) {
    const Mesh mesh = ball_arrays(40, doubles, !doubles);
    write_file(input, ply_of_arrays(mesh));
    int number = 0;
    for (const SimplifyOptions& options : stream_targets()) {
      CAPTURE(doubles, number++);
      VertexMap right_map;
      simplify(context, MeshSource(input), MeshSink(output), options, &right_map);
      const std::string right = bytes_of_file(output);
      CHECK(right_map.size() == mesh.vertex_count());
      const std::vector<std::function<MeshSource()>> sources{
          [&] { return MeshSource(input); }, [&] { return MeshSource(mesh); },
          [&] { return MeshSource(BatchSource(MeshParts(mesh, 11, false))); },
          [&] { return MeshSource(BatchSource(MeshParts(mesh, 12, true))); }};
      for (const auto& source : sources) {
        VertexMap map;
        Mesh result;
        const SimplifyReport report = simplify(context, source(), MeshSink(result), options, &map);
        CHECK((ply_of_arrays(result, "simplified by winnow") == right));
        CHECK(map == right_map);
        CHECK(report.input.faces == mesh.face_count());
        CollectedMesh collected;
        simplify(context, source(), MeshSink(collected.sink()), options);
        CHECK((ply_of_arrays(collected.mesh, "simplified by winnow") == right));
        simplify(context, source(), MeshSink(output), options);
        CHECK((bytes_of_file(output) == right));
      }
    }
  }
}

TEST_CASE("a mesh that is added with what it carries", "[library][same_bytes]") {
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  const Mesh mesh = ball_arrays(40, false, true);
  SimplifyOptions options;
  options.target = Target::faces(500);
  const Mesh right = simplify(context, mesh.view(), options);
  REQUIRE(right.attributes.size() == 5);
  Simplification simplification(context, options);
  MeshParts parts(mesh, 3, false);
  for (MeshView batch; parts(batch);) simplification.add(batch);
  CHECK((ply_of_arrays(simplification.finish_mesh()) == ply_of_arrays(right)));
}

TEST_CASE("loose triangles may carry something", "[library][same_bytes]") {
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  const Mesh mesh = ball_arrays(30, false, true);
  Mesh loose;
  std::vector<float> positions;
  std::vector<double> heat;
  const auto& from = std::get<std::vector<float>>(mesh.positions);
  const auto& values = std::get<std::vector<double>>(mesh.attributes[4].values);
  for (const std::uint32_t corner : mesh.faces) {
    positions.insert(positions.end(), from.begin() + 3 * corner, from.begin() + 3 * corner + 3);
    heat.push_back(values[corner]);
    loose.faces.push_back(static_cast<std::uint32_t>(loose.faces.size()));
  }
  loose.positions = positions;
  loose.attributes = {{"heat", heat}};
  SimplifyOptions options;
  options.target = Target::faces(500);
  VertexMap right_map;
  const Mesh right = simplify(context, loose.view(), options, nullptr, &right_map);
  REQUIRE(right.attributes.size() == 1);
  Mesh result;
  VertexMap map;
  bool given = false;
  const auto all_at_once = [&](MeshView& batch) {
    batch = loose.view();
    batch.faces = {};
    return !std::exchange(given, true);
  };
  simplify(context, MeshSource(MeshSource::Triangles{all_at_once}), MeshSink(result), options,
           &map);
  CHECK((ply_of_arrays(result) == ply_of_arrays(right)));
  CHECK(map == right_map);
}

TEST_CASE("batches that make no mesh are refused by the name of the array", "[library]") {
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  SimplifyOptions options;
  options.target = Target::faces(50);
  const Mesh mesh = ball_arrays(10, false, true);
  const auto refusal = [&](std::vector<MeshView> batches) {
    std::size_t next = 0;
    const auto source = [&](MeshView& batch) {
      if (next == batches.size()) return false;
      batch = batches[next++];
      return true;
    };
    Mesh result;
    const Error error = error_of(
        [&] { simplify(context, MeshSource(BatchSource(source)), MeshSink(result), options); });
    CHECK(directory.names().empty());
    return std::pair(error.kind(), std::string(error.what()));
  };
  const auto check = [](const std::pair<ErrorKind, std::string>& found, ErrorKind kind,
                        const std::string& words) {
    INFO(found.second);
    CHECK(found.first == kind);
    CHECK(found.second.find(words) != std::string::npos);
  };
  MeshView vertices = mesh.view();
  vertices.faces = {};
  MeshView faces;
  faces.faces = mesh.faces;
  check(refusal({}), ErrorKind::bad_input, "no face was added");
  check(refusal({vertices}), ErrorKind::bad_input, "no face was added");
  check(refusal({faces}), ErrorKind::bad_input, "no face that could be simplified");
  MeshView bare = vertices;
  bare.attributes.clear();
  check(refusal({vertices, bare, faces}), ErrorKind::usage, "`attributes` of all batches");
  MeshView renamed = vertices;
  renamed.attributes[0].name = "rot";
  check(refusal({vertices, renamed}), ErrorKind::usage, "`attributes` of all batches");
  MeshView doubled = vertices;
  const std::vector<double> doubles(3 * vertices.positions.count());
  doubled.positions = doubles;
  check(refusal({vertices, doubled}), ErrorKind::usage, "`positions` were added as floats and as");
  MeshView shorter = vertices;
  shorter.attributes[1].values = {static_cast<const std::uint8_t*>(nullptr), 0, 1};
  check(refusal({shorter}), ErrorKind::bad_input, "`attributes`: 'green' has 0 values");
  MeshView cut;
  cut.faces = std::span(mesh.faces).first(8);
  check(refusal({vertices, cut}), ErrorKind::bad_input, "`faces` holds 8 numbers");
  MeshView whole;
  whole.positions = mesh.faces;
  check(refusal({whole}), ErrorKind::usage, "`positions` takes floats or doubles");
  Mesh result;
  check(std::pair(ErrorKind::usage, std::string(error_of([&] {
                                                  simplify(context, MeshSource(BatchSource()),
                                                           MeshSink(result), options);
                                                }).what())),
        ErrorKind::usage, "no function that gives batches");
}

TEST_CASE("what a caller's functions throw comes out again", "[library]") {
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  SimplifyOptions options;
  options.target = Target::faces(50);
  const Mesh mesh = ball_arrays(10, false, false);
  Mesh result;
  const auto broken = [](MeshView&) -> bool { throw std::logic_error("of the source"); };
  CHECK_THROWS_WITH(simplify(context, MeshSource(BatchSource(broken)), MeshSink(result), options),
                    "of the source");
  const auto full = [](const MeshView&) { throw std::logic_error("of the sink"); };
  CHECK_THROWS_WITH(simplify(context, MeshSource(mesh), MeshSink(BatchSink(full)), options),
                    "of the sink");
  CHECK(directory.names().empty());
}

}  // namespace winnow::test
