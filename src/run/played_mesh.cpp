#include "run/played_mesh.hpp"

#include "base/memory_shares.hpp"
#include "cluster/weld_lattice.hpp"
#include "stitch/round_output.hpp"

#include <algorithm>
#include <memory_resource>
#include <utility>
#include <vector>

namespace winnow {

namespace {

constexpr std::size_t vertices_at_once = 4096;
constexpr std::uint32_t faces_at_once = 4096;

struct KeyedVertex {
  CellKey key;
  std::uint32_t vertex;

  friend bool operator<(const KeyedVertex& a, const KeyedVertex& b) {
    return a.key != b.key ? a.key < b.key : a.vertex < b.vertex;
  }
};

class Ordering {
 public:
  Ordering(Job& job, const SplitPlayer& player, ScratchMemory* scratch)
      : job_(job),
        player_(player),
        mesh_(player.mesh()),
        scratch_(scratch),
        reserved_(job.budget.reserve(
            scratch == nullptr ? ordering_memory(mesh_.vertices(), mesh_.faces()) : 0,
            "ordering so many faces")),
        order_(memory()),
        number_(memory()),
        normal_(memory()) {}

  StoredMesh run(std::span<const std::size_t> carried, bool normals) {
    order_vertices();
    if (normals) sum_normals();
    StoredMesh out(job_, {0, carried.size()},
                   MeshMemory::divide(share::left::added_mesh(job_.budget.left())));
    put_vertices(carried, out);
    put_faces(out);
    return out;
  }

 private:
  std::pmr::memory_resource* memory() const {
    return scratch_ != nullptr ? scratch_ : std::pmr::get_default_resource();
  }
  Point position(std::uint32_t v) const { return player_.words().position(mesh_.words(v)); }
  // Every few thousand steps.
  void turn() const {
    job_.progress.check_cancelled();
    if (scratch_ != nullptr) scratch_->give_back();
  }

  void order_vertices() {
    const Grid lattice = lattice_over(player_.header().box);
    order_.reserve(mesh_.vertices());
    for (std::uint32_t v = 0; v < mesh_.vertices(); ++v) {
      if (mesh_.has_faces(v)) order_.push_back({key_of(lattice, position(v)), v});
      if (v % vertices_at_once == 0) turn();
    }
    std::uint32_t compared = 0;
    std::sort(order_.begin(), order_.end(), [&](const KeyedVertex& a, const KeyedVertex& b) {
      if (++compared % 65536 == 0) turn();
      return a < b;
    });
    number_.assign(mesh_.vertices(), no_number);
    for (std::uint32_t i = 0; i < order_.size(); ++i) number_[order_[i].vertex] = i;
  }

  void sum_normals() {
    normal_.assign(mesh_.vertices(), Point{});
    for (std::uint32_t f = 0; f < mesh_.faces(); ++f) {
      const FaceVertices& face = mesh_.face(f);
      const Point area = doubled_area({position(face[0]), position(face[1]), position(face[2])});
      for (const std::uint32_t v : face) normal_[v] = normal_[v] + area;
      if (f % faces_at_once == 0) turn();
    }
  }

  void put_vertices(std::span<const std::size_t> carried, StoredMesh& out) const {
    std::vector<IndexedVertex> vertices;
    std::vector<double> means(player_.header().attributes.size());
    std::vector<double> numbers;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::uint32_t v = order_[i].vertex;
      vertices.push_back({order_[i].key, position(v), {}, 0});
      if (!normal_.empty()) vertices.back().normal = normal_along(normal_[v]);
      if (!carried.empty()) player_.words().means(mesh_.words(v), means);
      for (const std::size_t attribute : carried) numbers.push_back(means[attribute]);
      if (vertices.size() < vertices_at_once && i + 1 < order_.size()) continue;
      turn();
      out.append_vertices(vertices, {}, numbers);
      vertices.clear();
      numbers.clear();
    }
    out.finish_vertices();
  }

  // By their lowest vertices, of which each has few.
  void put_faces(StoredMesh& out) const {
    std::pmr::vector<std::uint32_t> end(order_.size() + 1, 0, memory());
    const auto renumbered = [&](std::uint32_t f) -> FaceVertices {
      const FaceVertices& face = mesh_.face(f);
      return {number_[face[0]], number_[face[1]], number_[face[2]]};
    };
    for (std::uint32_t f = 0; f < mesh_.faces(); ++f) {
      const FaceVertices face = renumbered(f);
      ++end[std::min({face[0], face[1], face[2]}) + 1];
      if (f % faces_at_once == 0) turn();
    }
    for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
    std::pmr::vector<FaceVertices> faces(mesh_.faces(), memory());
    for (std::uint32_t f = 0; f < mesh_.faces(); ++f) {
      const FaceVertices face = renumbered(f);
      // Without a branch: any corner is as often the lowest.
      const std::size_t low =
          face[0] < face[1] ? (face[0] < face[2] ? 0 : 2) : (face[1] < face[2] ? 1 : 2);
      faces[end[face[low]]++] = {face[low], face[(low + 1) % 3], face[(low + 2) % 3]};
      if (f % faces_at_once == 0) turn();
    }
    // `end` now is where each vertex's faces end.
    std::uint32_t begin = 0, told = 0;
    for (std::size_t v = 0; v < order_.size(); begin = end[v++]) {
      std::sort(faces.begin() + begin, faces.begin() + end[v]);
      if (end[v] - told < faces_at_once && v + 1 < order_.size()) continue;
      out.append_faces(std::span(faces).subspan(told, end[v] - told));
      told = end[v];
      turn();
    }
    out.finish_faces();
  }

  Job& job_;
  const SplitPlayer& player_;
  const SplitMesh& mesh_;
  ScratchMemory* scratch_;
  Reservation reserved_;
  std::pmr::vector<KeyedVertex> order_;
  std::pmr::vector<std::uint32_t> number_;  // of each vertex in the order
  std::pmr::vector<Point> normal_;
};

}  // namespace

std::uint64_t ordering_memory(std::uint64_t vertices, std::uint64_t faces) {
  return vertices * (sizeof(KeyedVertex) + 2 * sizeof(std::uint32_t) + sizeof(Point)) +
         faces * sizeof(FaceVertices);
}

StoredMesh stored_mesh(Job& job, const SplitPlayer& player, std::span<const std::size_t> carried,
                       bool normals, ScratchMemory* scratch) {
  return Ordering(job, player, scratch).run(carried, normals);
}

}  // namespace winnow
