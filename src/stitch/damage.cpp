#include "stitch/damage.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
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

Damage damage_of(const Tile& tile) {
  std::vector<std::uint32_t> first(tile.own_vertices + 1, 0);
  const auto for_each_own = [&](const auto& each) {
    for (const FaceVertices& face : tile.faces) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (face[i] < tile.own_vertices) each(face[i], Sides{face[(i + 1) % 3], face[(i + 2) % 3]});
      }
    }
  };
  for_each_own([&](VertexNumber v, const Sides&) { ++first[v + 1]; });
  for (std::size_t v = 0; v < tile.own_vertices; ++v) first[v + 1] += first[v];
  std::vector<Sides> sides(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for_each_own([&](VertexNumber v, const Sides& side) { sides[next[v]++] = side; });
  Damage out;
  std::vector<Sides> around;
  std::vector<VertexNumber> ends;
  for (VertexNumber v = 0; v < tile.own_vertices; ++v) {
    Fan fan = Fan::damaged;
    if (tile.locked[v] != fixed_hub) {
      around.assign(sides.begin() + first[v], sides.begin() + first[v + 1]);
      fan = fan_of(around, ends);
    }
    if (fan == Fan::closed) continue;
    (fan == Fan::open ? out.at_boundaries : out.vertices)
        .push_back(static_cast<std::uint32_t>(tile.first_vertex + v));
  }
  return out;
}

void add_to(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::uint64_t memory_of(std::uint64_t vertices, std::uint64_t faces) {
  return Tile::memory(vertices, faces, 0) + vertices * 2 * sizeof(std::uint32_t) + faces * 3 * sizeof(Sides);
}

}  // namespace

std::optional<Damage> find_damage(Job& job, const RefinedMesh& whole, std::uint64_t most,
                                  std::uint64_t memory) {
  const Tiling tiling(whole.mesh, damage_tile_faces);
  const IncomingFaces incoming(job, whole.mesh, tiling, memory, damage_hub_faces);
  const std::uint64_t largest = largest_tile(tiling, incoming, memory_of);
  const std::uint64_t at_once = std::clamp<std::uint64_t>(memory / largest, 1, job.threads);
  const Reservation reserved = job.budget.reserve(at_once * largest, "looking at a tile");
  Damage damage;
  std::atomic<bool> too_much{false};
  std::size_t next = 0;
  pipeline<std::pair<std::size_t, Damage>>(
      at_once,
      [&](auto& item) {
        item.first = next++;
        return item.first < tiling.tiles() && !too_much;
      },
      [&](auto& item) {
        const Tile tile = load_tile(whole, tiling, incoming, item.first, 0, 0);
        item.second = damage_of(tile);
        job.progress.advance(tile.own_faces);
      },
      [&](const auto& item) {
        add_to(damage.vertices, item.second.vertices);
        add_to(damage.at_boundaries, item.second.at_boundaries);
        too_much = damage.vertices.size() + damage.at_boundaries.size() > most;
      });
  if (too_much) return std::nullopt;
  return damage;
}

}  // namespace winnow
