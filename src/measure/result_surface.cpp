#include "measure/result_surface.hpp"

#include "base/hash.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "measure/edge_count.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace winnow {

namespace {

using Corners3 = std::array<std::uint32_t, 3>;

struct PackedEdge {
  std::uint64_t ends;  // the lower number in the higher half

  static bool before(const PackedEdge& a, const PackedEdge& b) { return a.ends < b.ends; }
  static bool combine(PackedEdge& /*into*/, const PackedEdge& /*from*/) { return false; }
};

PackedEdge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)};
}

// Which faces leave the two edges at their first vertex to be counted when that vertex's turn
// comes: those that come in the order of it, and no more of one vertex than memory always has room
// for.
class InTurn {
 public:
  bool operator()(std::uint32_t first) {
    if (first < last_ && seen_) return false;
    run_ = seen_ && first == last_ ? run_ + 1 : 0;
    last_ = first;
    seen_ = true;
    return run_ < most;
  }

  static constexpr std::uint64_t most = std::uint64_t{1} << 16;

 private:
  std::uint32_t last_ = 0;
  bool seen_ = false;
  std::uint64_t run_ = 0;
};

// Vertices that faces join, in four bytes each.
class JoinedVertices {
 public:
  explicit JoinedVertices(std::uint64_t vertices) : above_(vertices, unused) {}

  static std::uint64_t bytes(std::uint64_t vertices) { return vertices * sizeof(std::uint32_t); }

  void add(const Corners3& face) {
    std::uint32_t lowest = top(face[0]);
    for (const std::uint32_t vertex : {face[1], face[2]}) {
      const std::uint32_t other = top(vertex);
      if (other == lowest) continue;
      above_[std::max(lowest, other)] = std::min(lowest, other);
      lowest = std::min(lowest, other);
      --pieces_;
    }
  }
  [[nodiscard]] std::uint64_t pieces() const { return pieces_; }

 private:
  static constexpr std::uint32_t unused = UINT32_MAX;

  std::uint32_t top(std::uint32_t vertex) {
    if (above_[vertex] == unused) {
      above_[vertex] = vertex;
      ++pieces_;
    }
    while (above_[vertex] != vertex) vertex = above_[vertex] = above_[above_[vertex]];
    return vertex;
  }

  std::vector<std::uint32_t> above_;
  std::uint64_t pieces_ = 0;
};

Corners3 lowest_first(Corners3 face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// Each side adds a hash; that of the opposite direction takes it away.
std::uint64_t directions_of(const Corners3& face) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t from = face[i], to = face[(i + 1) % 3];
    const std::uint64_t hash = mixed_hash(edge_of(from, to).ends);
    sum += from < to ? hash : ~hash + 1;
  }
  return sum;
}

}  // namespace

bool is_closed(Job& job, const ClusteredMesh& mesh) {
  job.progress.begin("check", mesh.face_count, "faces");
  std::uint64_t directions = 0;
  SpoolCursor<Corners3> faces(job, *mesh.faces);
  for (Corners3 face; faces.next(face);) directions += directions_of(face);
  return mesh.face_count > 0 && directions == 0;
}

ResultSurface measure_result(Job& job, const ClusteredMesh& mesh, std::uint64_t memory) {
  ResultSurface out;
  job.progress.begin("check", 2 * mesh.face_count, "faces");
  std::optional<JoinedVertices> joined;
  Reservation for_joined;
  if (const std::uint64_t bytes = JoinedVertices::bytes(mesh.vertices->size());
      bytes <= memory / 2) {
    memory -= bytes;
    for_joined = job.budget.reserve(bytes, "counting pieces");
    joined.emplace(mesh.vertices->size());
  }
  SortedRecords<PackedEdge> list(job, memory);
  std::uint64_t directions = 0;
  {
    VertexIndex::Reader vertices(*mesh.vertices);
    SpoolCursor<Corners3> faces(job, *mesh.faces);
    InTurn in_turn;
    for (Corners3 face; faces.next(face);) {
      const Point a = vertices.position(face[0]);
      const Point u = vertices.position(face[1]) - a;
      const Point v = vertices.position(face[2]) - a;
      out.area += length(cross(u, v)) / 2;
      directions += directions_of(face);
      if (joined) joined->add(face);
      const auto [first, second, third] = lowest_first(face);
      list.add(edge_of(second, third));
      if (in_turn(first)) continue;
      list.add(edge_of(first, second));
      list.add(edge_of(first, third));
    }
  }
  job.progress.advance(mesh.face_count);
  if (joined) out.pieces = joined->pieces();
  joined.reset();
  for_joined.release();
  out.closed = mesh.face_count > 0 && directions == 0;

  MergedCursor<PackedEdge> sorted = list.merged();
  PackedEdge next{};
  bool more = sorted.next(next);
  EdgeRuns runs;
  std::vector<std::uint64_t> turn;  // edges of the vertex whose turn it is
  const auto take_turn = [&] {
    if (turn.empty()) return;
    std::sort(turn.begin(), turn.end());
    for (const std::uint64_t edge : turn) {
      for (; more && next.ends < edge; more = sorted.next(next)) runs.add(next.ends);
      runs.add(edge);
    }
    turn.clear();
  };
  SpoolCursor<Corners3> faces(job, *mesh.faces);
  InTurn in_turn;
  std::uint32_t of = 0;
  for (Corners3 face; faces.next(face);) {
    const auto [first, second, third] = lowest_first(face);
    if (!in_turn(first)) continue;
    if (first != of) take_turn();
    of = first;
    turn.push_back(edge_of(first, second).ends);
    turn.push_back(edge_of(first, third).ends);
  }
  take_turn();
  for (std::uint64_t seen = 0; more; more = sorted.next(next)) {
    if (++seen % chunk_records == 0) job.progress.check_cancelled();
    runs.add(next.ends);
  }
  out.edges = runs.finish();
  return out;
}

}  // namespace winnow
