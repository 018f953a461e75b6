#include "stitch/damage.hpp"

#include "base/closest_point.hpp"
#include "base/parallel.hpp"
#include "base/sort_unique.hpp"
#include "base/vector.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

namespace winnow {

namespace {

constexpr std::uint64_t damage_tile_faces = std::uint64_t{1} << 16;
constexpr std::uint64_t damage_hub_faces = 512;

// The other two corners of each face around a vertex.
using Sides = std::array<VertexNumber, 2>;

enum class Fan { closed, open, damaged };

// Sorts `sides`.
Fan fan_of(std::vector<Sides>& sides, std::vector<VertexNumber>& ends) {
  if (sides.empty()) return Fan::closed;
  std::sort(sides.begin(), sides.end());
  ends.clear();
  for (const Sides& side : sides) ends.push_back(side[1]);
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i][0] == sides[i - 1][0] || ends[i] == ends[i - 1]) return Fan::damaged;
  }
  // The side that no other leads to, if there is one: there an open fan begins.
  std::size_t begin = 0;
  bool open = false;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (std::binary_search(ends.begin(), ends.end(), sides[i][0])) continue;
    if (open) return Fan::damaged;
    open = true;
    begin = i;
  }
  std::size_t walked = 1;
  for (VertexNumber at = sides[begin][1]; at != sides[begin][0]; ++walked) {
    const auto next = std::lower_bound(sides.begin(), sides.end(), Sides{at, 0});
    if (next == sides.end() || (*next)[0] != at) break;
    at = (*next)[1];
  }
  if (walked != sides.size()) return Fan::damaged;
  return open ? Fan::open : Fan::closed;
}

// The faces that fell together, and what the tiles find out about each.
class FallenFaces {
 public:
  FallenFaces(Job& job, const StoredMesh& mesh, const Spool* fused) {
    if (fused == nullptr) return;
    const std::uint64_t count = record_count<FusedFace>(*fused);
    reserved_ = job.budget.reserve(
        count * (sizeof(FusedFace) + sizeof(Finding)) + mesh.vertices->size() / 8,
        "faces that fell together");
    faces_.resize(count);
    fused->read(0, std::as_writable_bytes(std::span(faces_)));
    std::sort(faces_.begin(), faces_.end(),
              [](const FusedFace& a, const FusedFace& b) { return a.vertices < b.vertices; });
    findings_.resize(count);
    touched_.resize(mesh.vertices->size());
    for (const FusedFace& face : faces_) {
      for (const std::uint32_t v : face.vertices) touched_[v] = true;
    }
  }

  [[nodiscard]] bool touch(std::uint64_t vertex) const {
    return !touched_.empty() && touched_[vertex];
  }

  static constexpr std::size_t none = SIZE_MAX;
  // By numbers in the whole mesh.
  [[nodiscard]] std::size_t find(const FaceVertices& face) const {
    const FaceVertices wanted = lowest_first(face);
    const auto at = std::lower_bound(faces_.begin(), faces_.end(), wanted,
                                     [](const FusedFace& fused, const FaceVertices& vertices) {
                                       return fused.vertices < vertices;
                                     });
    return at == faces_.end() || at->vertices != wanted
               ? none
               : static_cast<std::size_t>(at - faces_.begin());
  }
  [[nodiscard]] std::uint64_t faces(std::size_t i) const {
    return std::uint64_t{faces_[i].along} + faces_[i].against;
  }
  [[nodiscard]] bool goes(std::size_t i) const { return faces_[i].along == faces_[i].against; }

  // `others`: other faces at those two of its edges that meet in one of its vertices.
  void add(std::size_t i, std::uint64_t others) {
    findings_[i].others += others;
    ++findings_[i].corners;
  }
  void refuse(std::size_t i) { findings_[i].refused = true; }

  void tell(Damage& damage) const {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (is_fold(i)) {
        if (goes(i)) damage.folds.push_back(faces_[i].vertices);
      } else {
        damage.vertices.insert(damage.vertices.end(), faces_[i].vertices.begin(),
                               faces_[i].vertices.end());
      }
    }
  }

 private:
  struct Finding {
    std::uint64_t others = 0;  // each edge twice
    unsigned corners = 0;
    bool refused = false;
  };

  // n faces hang together by n - 1 of their edges at least, so that at most n + 2 have others
  // beside them. Of more than three that says too little. One that no other face touches is a
  // piece.
  [[nodiscard]] bool is_fold(std::size_t i) const {
    const Finding& found = findings_[i];
    return faces(i) <= 3 && !found.refused && found.corners == 3 && found.others > 0 &&
           found.others <= 2 * (faces(i) + 2);
  }

  Reservation reserved_;
  std::vector<FusedFace> faces_;
  std::vector<Finding> findings_;
  std::vector<bool> touched_;  // vertices that have such a face
};

// What one tile tells.
struct TileDamage {
  Damage damage;
  std::vector<std::pair<std::size_t, std::uint64_t>> others;
  std::vector<std::size_t> refused;
};

class TileLook {
 public:
  TileLook(const Tile& tile, const FallenFaces& fallen, double reach)
      : tile_(tile), fallen_(fallen), reach_(reach) {
    std::vector<std::uint32_t> next(tile.own_vertices + 1, 0);
    for_each_own([&](VertexNumber v, const Sides&) { ++next[v + 1]; });
    for (std::size_t v = 0; v < tile.own_vertices; ++v) next[v + 1] += next[v];
    first_ = next;
    sides_.resize(first_.back());
    for_each_own([&](VertexNumber v, const Sides& side) { sides_[next[v]++] = side; });
  }

  TileDamage run() {
    for (VertexNumber v = 0; v < tile_.own_vertices; ++v) {
      const auto number = static_cast<std::uint32_t>(tile_.first_vertex + v);
      Fan fan = Fan::damaged;
      if (tile_.locked[v] != fixed_hub) {
        around_.assign(sides_.begin() + first_[v], sides_.begin() + first_[v + 1]);
        fan = fallen_.touch(number) ? fan_with_fallen(v) : fan_of(around_, ends_);
      }
      if (fan == Fan::closed) continue;
      (fan == Fan::open ? out_.damage.at_boundaries : out_.damage.vertices).push_back(number);
    }
    return std::move(out_);
  }

 private:
  template <typename Each>
  void for_each_own(const Each& each) const {
    for (const FaceVertices& face : tile_.faces) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (face[i] < tile_.own_vertices)
          each(face[i], Sides{face[(i + 1) % 3], face[(i + 2) % 3]});
      }
    }
  }

  [[nodiscard]] std::uint32_t number(VertexNumber v) const {
    return v < tile_.own_vertices ? static_cast<std::uint32_t>(tile_.first_vertex + v)
                                  : tile_.others[v - tile_.own_vertices];
  }

  // Tells of each face of `v` that fell together what other faces are beside it.
  Fan fan_with_fallen(VertexNumber v) {
    struct Seen {
      Sides side;
      std::size_t fallen;
      std::uint64_t faces;
    };
    std::vector<Seen> seen;
    std::vector<std::pair<VertexNumber, std::uint64_t>>
        beside;  // neighbours, and faces at the edge to each
    for (const Sides& side : around_) {
      const std::size_t i = fallen_.find({number(v), number(side[0]), number(side[1])});
      seen.push_back({side, i, i == FallenFaces::none ? 1 : fallen_.faces(i)});
      for (const VertexNumber neighbour : side) beside.emplace_back(neighbour, seen.back().faces);
    }
    // Very many faces may be at one edge, so each is gone through once.
    std::sort(beside.begin(), beside.end());
    std::size_t edges = 0;
    for (const auto& [neighbour, faces] : beside) {
      if (edges > 0 && beside[edges - 1].first == neighbour) {
        beside[edges - 1].second += faces;
      } else {
        beside[edges++] = {neighbour, faces};
      }
    }
    beside.resize(edges);
    const auto faces_at = [&](VertexNumber neighbour) {
      return std::lower_bound(beside.begin(), beside.end(), std::pair{neighbour, std::uint64_t{0}})
          ->second;
    };
    around_.clear();
    for (const Seen& face : seen) {
      if (face.fallen == FallenFaces::none || !fallen_.goes(face.fallen))
        around_.push_back(face.side);
      if (face.fallen == FallenFaces::none) continue;
      out_.others.emplace_back(face.fallen,
                               faces_at(face.side[0]) + faces_at(face.side[1]) - 2 * face.faces);
    }
    if (!around_.empty()) return fan_of(around_, ends_);
    if (seen.size() == 1 && near_edge(v, seen[0].side)) {
      out_.damage.folded.push_back(number(v));
      return Fan::closed;
    }
    for (const Seen& face : seen) out_.refused.push_back(face.fallen);
    return Fan::damaged;
  }

  [[nodiscard]] bool near_edge(VertexNumber v, const Sides& edge) const {
    const Point& at = tile_.positions[v];
    const Point& end = tile_.positions[edge[1]];
    const Point nearest = closest_point(at, {tile_.positions[edge[0]], end, end});
    return length(at - nearest) <= reach_;
  }

  const Tile& tile_;
  const FallenFaces& fallen_;
  double reach_;
  std::vector<std::uint32_t> first_;
  std::vector<Sides> sides_;  // vertex by vertex
  std::vector<Sides> around_;
  std::vector<VertexNumber> ends_;
  TileDamage out_;
};

void add_to(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void remove_from(std::vector<std::uint32_t>& numbers, const std::vector<std::uint32_t>& others) {
  std::vector<std::uint32_t> left;
  std::set_difference(numbers.begin(), numbers.end(), others.begin(), others.end(),
                      std::back_inserter(left));
  numbers = std::move(left);
}

std::uint64_t memory_of(std::uint64_t vertices, std::uint64_t faces) {
  return Tile::memory(vertices, faces, 0) + vertices * 2 * sizeof(std::uint32_t) +
         faces * 3 * sizeof(Sides);
}

}  // namespace

std::optional<Damage> find_damage(Job& job, const StoredMesh& whole, const Spool* fused,
                                  std::uint64_t most, double reach, std::uint64_t memory) {
  if (fused != nullptr && record_count<FusedFace>(*fused) > most) return std::nullopt;
  FallenFaces fallen(job, whole, fused);
  const Tiling tiling(whole, damage_tile_faces);
  const IncomingFaces incoming(job, whole, tiling, memory, damage_hub_faces);
  const std::uint64_t largest = largest_tile(tiling, incoming, memory_of);
  const std::uint64_t at_once = std::clamp<std::uint64_t>(memory / largest, 1, job.threads);
  const Reservation reserved = job.budget.reserve(at_once * largest, "looking at a tile");
  Damage damage;
  std::atomic<bool> too_much{false};
  std::size_t next = 0;
  pipeline<std::pair<std::size_t, TileDamage>>(
      at_once,
      [&](auto& item) {
        item.first = next++;
        return item.first < tiling.tiles() && !too_much;
      },
      [&](auto& item) {
        const Tile tile = load_tile(whole, tiling, incoming, item.first, {.records = false});
        item.second = TileLook(tile, fallen, reach).run();
        job.progress.advance(tile.own_faces);
      },
      [&](const auto& item) {
        const TileDamage& found = item.second;
        add_to(damage.vertices, found.damage.vertices);
        add_to(damage.at_boundaries, found.damage.at_boundaries);
        add_to(damage.folded, found.damage.folded);
        for (const auto& [face, others] : found.others) fallen.add(face, others);
        for (const std::size_t face : found.refused) fallen.refuse(face);
        too_much = damage.vertices.size() + damage.at_boundaries.size() > most;
      });
  if (too_much) return std::nullopt;
  fallen.tell(damage);
  sort_unique(damage.vertices);
  remove_from(damage.at_boundaries, damage.vertices);
  remove_from(damage.folded, damage.vertices);
  if (damage.vertices.size() + damage.at_boundaries.size() > most) return std::nullopt;
  return damage;
}

}  // namespace winnow
