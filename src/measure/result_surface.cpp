#include "measure/result_surface.hpp"

#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "io/parted_records.hpp"
#include "io/spool_records.hpp"
#include "measure/edge_count.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

namespace {

struct PackedEdge {
  std::uint64_t ends;  // the lower number in the higher half

  [[nodiscard]] std::uint64_t rank() const { return ends; }
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

  void add(const FaceVertices& face) {
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

// The edges at their first vertices of faces that leave them to be counted in turn, in order.
class EdgesInTurn {
 public:
  EdgesInTurn(const Job& job, const Spool& faces) : faces_(job, faces) { more_ = next_face(); }

  bool next(std::uint64_t& edge) {
    if (at_ == edges_.size() && !next_vertex()) return false;
    edge = edges_[at_++];
    return true;
  }

 private:
  bool next_vertex() {
    edges_.clear();
    at_ = 0;
    if (!more_) return false;
    const std::uint32_t first = face_[0];
    for (; more_ && face_[0] == first; more_ = next_face()) {
      edges_.push_back(edge_of(first, face_[1]).ends);
      edges_.push_back(edge_of(first, face_[2]).ends);
    }
    std::sort(edges_.begin(), edges_.end());
    return true;
  }

  bool next_face() {
    while (faces_.next(face_)) {
      face_ = lowest_first(face_);
      if (in_turn_(face_[0])) return true;
    }
    return false;
  }

  SpoolCursor<FaceVertices> faces_;
  InTurn in_turn_;
  FaceVertices face_{};
  bool more_;
  std::vector<std::uint64_t> edges_;  // of one vertex
  std::size_t at_ = 0;
};

// Each side adds a hash; that of the opposite direction takes it away.
std::uint64_t directions_of(const FaceVertices& face) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t from = face[i], to = face[(i + 1) % 3];
    const std::uint64_t hash = mixed_hash(edge_of(from, to).ends);
    sum += from < to ? hash : ~hash + 1;
  }
  return sum;
}

}  // namespace

bool is_closed(Job& job, const StoredMesh& mesh) {
  job.progress.begin("check", mesh.face_count, "faces");
  std::uint64_t directions = 0;
  SpoolCursor<FaceVertices> faces = mesh.face_cursor(job);
  for (FaceVertices face; faces.next(face);) directions += directions_of(face);
  return mesh.face_count > 0 && directions == 0;
}

namespace {

ResultSurface survey(Job& job, const StoredMesh& mesh, std::uint64_t memory, bool areas) {
  ResultSurface out;
  job.progress.begin("check", 2 * mesh.face_count, "faces");
  std::optional<JoinedVertices> joined;
  Reservation for_joined;
  if (const std::uint64_t bytes = JoinedVertices::bytes(mesh.vertices->size());
      bytes <= share::count::joined_vertices(memory)) {
    memory -= bytes;
    for_joined = job.budget.reserve(bytes, "counting pieces");
    joined.emplace(mesh.vertices->size());
  }
  // One edge a face, and few besides.
  const PartsPlan plan =
      PartedRecords<PackedEdge>::plan(memory, job.threads, mesh.face_count, sizeof(PackedEdge));
  PartedRecords<PackedEdge> edges(job, plan);
  const std::uint64_t range = mesh.vertices->size() / plan.parts + 1;
  auto& lists = edges.local();
  const auto add = [&](std::uint32_t u, std::uint32_t v) {
    lists.add(std::min(u, v) / range, edge_of(u, v));
  };
  std::uint64_t directions = 0;
  {
    VertexIndex::Reader vertices(*mesh.vertices);
    SpoolCursor<FaceVertices> faces = mesh.face_cursor(job);
    InTurn in_turn;
    for (FaceVertices face; faces.next(face);) {
      if (areas) {
        const Point a = vertices.position(face[0]);
        const Point u = vertices.position(face[1]) - a;
        const Point v = vertices.position(face[2]) - a;
        out.area += length(cross(u, v)) / 2;
        directions += directions_of(face);
      }
      if (joined) joined->add(face);
      const auto [first, second, third] = lowest_first(face);
      add(second, third);
      if (in_turn(first)) continue;
      add(first, second);
      add(first, third);
    }
  }
  job.progress.advance(mesh.face_count);
  if (joined) out.pieces = joined->pieces();
  joined.reset();
  for_joined.release();
  out.closed = areas && mesh.face_count > 0 && directions == 0;

  EdgesInTurn turns(job, *mesh.faces);
  EdgeRuns runs;
  std::uint64_t next = 0;
  bool more = turns.next(next);
  edges.for_each_stretch<std::vector<PackedEdge>>(
      [](std::span<const PackedEdge> sorted, std::vector<PackedEdge>& copy) {
        copy.assign(sorted.begin(), sorted.end());
      },
      [&](const std::vector<PackedEdge>& sorted) {
        for (const PackedEdge& edge : sorted) {
          for (; more && next <= edge.ends; more = turns.next(next)) runs.add(next);
          runs.add(edge.ends);
        }
      });
  for (; more; more = turns.next(next)) runs.add(next);
  out.edges = runs.finish();
  return out;
}

}  // namespace

ResultSurface measure_result(Job& job, const StoredMesh& mesh, std::uint64_t memory) {
  return survey(job, mesh, memory, true);
}

CountedSurface count_surface(Job& job, const StoredMesh& mesh, std::uint64_t memory) {
  const ResultSurface surface = survey(job, mesh, memory, false);
  const CountedSurface& counted = surface;
  return counted;
}

}  // namespace winnow
