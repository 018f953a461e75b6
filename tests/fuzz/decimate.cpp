// Faces between any of a few vertices, many in the same place: the first byte says by which cost,
// the second how many vertices, then three bytes a vertex and three a face.
#include "decimate/decimation.hpp"
#include "fuzz/targets.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace winnow::fuzz {

namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool more() const { return !bytes_.empty(); }
  unsigned next() {
    if (bytes_.empty()) return 0;
    const auto byte = std::to_integer<unsigned>(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return byte;
  }

 private:
  std::span<const std::byte> bytes_;
};

struct Soup {
  std::vector<Point> positions;
  std::vector<FaceVertices> faces;
  std::vector<std::uint8_t> locked;

  [[nodiscard]] TileMesh mesh() const { return {positions, faces, locked}; }
};

Soup soup_of(Bytes& bytes) {
  Soup soup;
  const unsigned vertices = 3 + bytes.next() % 60;
  for (unsigned v = 0; v < vertices; ++v) {
    Point p{};
    unsigned lock = 0;
    for (double& x : p) {
      const unsigned byte = bytes.next();
      x = static_cast<double>(byte % 16) / (byte > 200 ? 1e6 : 8);
      lock += byte >> 7;
    }
    soup.positions.push_back(p);
    soup.locked.push_back(lock == 3);
  }
  std::set<std::set<VertexNumber>> seen;  // as after clustering: no face twice
  while (bytes.more()) {
    FaceVertices face{};
    for (VertexNumber& v : face) v = bytes.next() % vertices;
    const std::set<VertexNumber> key(face.begin(), face.end());
    if (key.size() == 3 && seen.insert(key).second) soup.faces.push_back(face);
  }
  return soup;
}

// What is left, in no order.
std::vector<Triangle> live(const TileMesh& mesh) {
  std::vector<Triangle> faces;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.removed(f)) faces.push_back(mesh.triangle(f));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

void check(const TileMesh& mesh, const Soup& soup) {
  std::uint64_t faces = 0;
  for (FaceNumber f = 0; f < mesh.face_count(); ++f) {
    if (mesh.removed(f)) continue;
    ++faces;
    const FaceVertices& face = mesh.face(f);
    for (const VertexNumber v : face) {
      expect(v < mesh.vertex_count(), "a face has vertices");
      expect(finite(mesh.position(v)), "a vertex is somewhere");
    }
    expect(face[0] != face[1] && face[1] != face[2] && face[2] != face[0],
           "a face has three corners");
  }
  expect(faces == mesh.live_faces(), "faces are counted");
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v)
    expect(soup.locked[v] == 0 || mesh.position(v) == soup.positions[v], "a locked vertex stays");
}

}  // namespace

void decimate(std::span<const std::byte> input) {
  Bytes bytes(input);
  const unsigned kind = bytes.next();
  DecimationSettings settings;
  settings.cost = static_cast<Refine>(1 + kind % (count_values<Refine>() - 1));
  settings.keep_boundaries = (kind & 16) != 0;
  settings.keep_pieces = (kind & 8) != 0;
  settings.free_topology = (kind & 128) != 0;
  settings.single = (kind & 32) == 0;
  if ((kind & 64) != 0 && facts_of(settings.cost).bounds_error) settings.error = 0.1;
  const Soup soup = soup_of(bytes);
  if (soup.faces.empty()) return;

  TileMesh mesh = soup.mesh();
  const auto decimation = Decimation::make(mesh, {}, settings);
  std::vector<Collapse> edges;
  double error = 0;
  std::uint64_t removed = 0;
  decimation->run({0}, [&](const DoneCollapse& done) {
    edges.push_back(done.edge);
    removed += done.faces;
    expect(done.faces > 0, "a collapse removes faces");
    expect(done.error >= error, "the largest error never falls");
    error = done.error;
  });
  check(mesh, soup);
  expect(removed + mesh.live_faces() == soup.faces.size(), "faces that went are counted");

  TileMesh again = soup.mesh();
  const auto repeated = Decimation::make(again, {}, settings);
  for (const Collapse& edge : edges) repeated->repeat(edge);
  expect(live(again) == live(mesh), "collapses can be repeated");
  const std::size_t size = Decimation::state_size(settings);
  std::vector<std::byte> one(size);
  std::vector<std::byte> other(size);
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    decimation->save(v, one.data());
    repeated->save(v, other.data());
    expect(one == other, "what is remembered can be repeated");
  }
}

}  // namespace winnow::fuzz
