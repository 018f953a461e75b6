#include "stitch/tiling.hpp"

#include "io/spool_records.hpp"

#include <array>

namespace winnow {

namespace {

struct Place {
  std::uint64_t vertex = 0, face = 0;
};

class Cutter {
 public:
  Cutter(const StoredMesh& mesh, std::uint64_t most)
      : mesh_(mesh), vertices_(*mesh.vertices), most_(most) {}

  // Cuts the keys from `low`, 3 * `level` bits of them, and writes where the tiles end.
  void cut(CellKey low, unsigned level, const Place& begin, const Place& end,
           std::vector<Place>& ends) {
    if (begin.vertex == end.vertex) return;
    if (level == 0 || fits(begin, end)) {
      ends.push_back(end);
      return;
    }
    const std::uint64_t eighth = std::uint64_t{1} << (3 * (level - 1));
    Place tile_begin = begin;  // of those joined so far
    Place tile_end = begin;
    for (std::uint64_t child = 0; child < 8; ++child) {
      const Place child_end = child == 7 ? end : place_of(low + (child + 1) * eighth);
      const Place child_begin = tile_end;
      if (fits(tile_begin, child_end)) {
        tile_end = child_end;
        continue;
      }
      if (tile_begin.vertex != child_begin.vertex) ends.push_back(child_begin);
      if (fits(child_begin, child_end)) {
        tile_begin = child_begin;
      } else {
        cut(low + child * eighth, level - 1, child_begin, child_end, ends);
        tile_begin = child_end;
      }
      tile_end = child_end;
    }
    if (tile_begin.vertex != tile_end.vertex) ends.push_back(tile_end);
  }

 private:
  [[nodiscard]] bool fits(const Place& begin, const Place& end) const {
    return end.vertex - begin.vertex <= most_ && end.face - begin.face <= most_;
  }

  Place place_of(CellKey key) {
    const std::uint64_t vertex = vertices_.lower_bound(key);
    return {vertex, first_face_of(vertex)};
  }

  // The first face whose lowest vertex is not below `vertex`.
  [[nodiscard]] std::uint64_t first_face_of(std::uint64_t vertex) const {
    std::uint64_t low = 0;
    std::uint64_t high = mesh_.face_count;
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      if (mesh_.face(middle)[0] < vertex) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  const StoredMesh& mesh_;
  VertexIndex::Reader vertices_;
  std::uint64_t most_;
};

}  // namespace

Tiling::Tiling(const StoredMesh& mesh, std::uint64_t tile_faces)
    : first_vertex_{0}, first_face_{0} {
  std::vector<Place> ends;
  Cutter(mesh, tile_faces).cut(0, axis_bits, {}, {mesh.vertices->size(), mesh.face_count}, ends);
  for (const Place& end : ends) {
    first_vertex_.push_back(end.vertex);
    first_face_.push_back(end.face);
  }
}

}  // namespace winnow
