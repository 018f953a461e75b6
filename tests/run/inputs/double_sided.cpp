// Of a mesh in which each face stands once in each sense one side is left, the same in any memory.
#include "support/refined_file.hpp"
#include "support/simplified.hpp"

#include <cmath>
#include <cstring>

namespace winnow::test {

namespace {

void append_bytes(std::string& to, const auto& value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// A long strip of hills: its vertices, of 48 bytes each, and some of its faces.
constexpr std::int32_t strip_width = 60;
constexpr std::int32_t strip_length = 2700;

std::string strip_of_hills(const std::vector<FaceVertices>& faces) {
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(strip_width * strip_length) + "\n";
  for (const char* name : {"x", "y", "z", "a", "b", "c"})
    file += std::string("property double ") + name + "\n";
  file += "element face " + std::to_string(faces.size()) +
          "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::int32_t i = 0; i < strip_width * strip_length; ++i) {
    const double x = i / strip_width;
    const double y = i % strip_width;
    for (const double value : {x, y, 3 * std::sin(x / 5) * std::cos(y / 7), 0.0, 0.0, 0.0})
      append_bytes(file, value);
  }
  for (const FaceVertices& face : faces) {
    file += '\3';
    append_bytes(file, face);
  }
  return file;
}

std::vector<FaceVertices> both_sides() {
  std::vector<FaceVertices> faces;
  for (std::uint32_t x = 0; x + 1 < strip_length; ++x) {
    for (std::uint32_t y = 0; y + 1 < strip_width; ++y) {
      const std::uint32_t i = x * strip_width + y;
      const std::uint32_t j = i + strip_width;
      for (const FaceVertices& face : {FaceVertices{i, j, j + 1}, FaceVertices{i, j + 1, i + 1}}) {
        faces.push_back(face);
        faces.push_back({face[0], face[2], face[1]});
      }
    }
  }
  return faces;
}

}  // namespace

TEST_CASE("a mesh with two sides keeps the first and says so") {
  const Directory directory;
  const std::vector<Triangle> outside = ball(20);
  std::vector<Triangle> faces = outside;
  for (const Triangle& face : outside) faces.push_back(turned(face));
  for (const std::uint64_t wanted : {300U, 100'000U}) {
    CAPTURE(wanted);
    const RefinedFile out = refine_faces(directory, faces, to_faces(wanted));
    const Defects defects = defects_of(out.mesh.faces);
    CHECK(defects.discords == 0);
    CHECK(defects.boundary_edges == 0);
    CHECK(defects.crowded == 0);
    for (std::size_t i = 0; i < out.mesh.faces.size(); ++i) {
      const Triangle face = out.mesh.triangle(i);
      CHECK(dot(area_vector(face), face[0] + face[1] + face[2]) > 0);
    }
    CHECK(out.report.merged_opposite_faces == outside.size());
    REQUIRE(out.report.notes.size() == 2);
    CHECK(out.report.notes[1].find("of the area") != std::string::npos);
    CHECK(out.report.notes[0] ==
          "1,520 faces stood twice, once in each sense: one side of each was kept, that of the "
          "first");
  }
}

TEST_CASE("the same bytes of a mesh with two sides whose faces are scattered", "[same_bytes]") {
  const Directory directory;
  std::vector<FaceVertices> faces = both_sides();
  Random random(920);
  random.shuffle(faces);
  const auto half = faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2);
  const std::string whole = directory.file("whole.ply");
  const std::string front = directory.file("front.ply");
  const std::string behind = directory.file("behind.ply");
  write_file(whole, strip_of_hills(faces));
  write_file(front, strip_of_hills({faces.begin(), half}));
  write_file(behind, strip_of_hills({half, faces.end()}));
  const Words options{"--faces", "310000", "--detail", "full", "--attributes", "none"};
  const Simplified want = simplified(directory, whole, options);
  CHECK(want.report["merged_opposite_faces"] == faces.size() / 2);
  const Words little = options + Words{"--threads", "2", "--memory",
                                       smallest_memory(whole, options + Words{"--threads", "2"})};
  const Simplified small = simplified(directory, whole, little);
  CHECK(small.report["spilled_bytes"] >= 16 * faces.size());
  CHECK(small.report["merged_opposite_faces"] == faces.size() / 2);
  CHECK(small.hash == want.hash);
  CHECK(simplified_by_pipe(directory, whole, little).hash == want.hash);
  CHECK(simplified(directory, front, Words{behind} + little).hash == want.hash);
}

}  // namespace winnow::test
