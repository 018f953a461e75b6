#include "measure/result_surface.hpp"

#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "io/parted_records.hpp"
#include "io/spool_records.hpp"
#include "measure/edge_count.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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

// The faces that leave edges to be counted in turn, from their lowest vertices on.
class FacesInTurn {
 public:
  explicit FacesInTurn(const Job& job, const StoredMesh& mesh) : faces_(mesh.face_cursor(job)) {}

  bool next(FaceVertices& face) {
    for (FaceVertices next; faces_.next(next);) {
      face = lowest_first(next);
      if (in_turn_(face[0])) return true;
    }
    return false;
  }

 private:
  SpoolCursor<FaceVertices> faces_;
  InTurn in_turn_;
};

// Their edges that are counted in turn, in order.
class EdgesInTurn {
 public:
  EdgesInTurn(const Job& job, const StoredMesh& mesh) : faces_(job, mesh) {
    more_ = faces_.next(face_);
  }

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
    for (; more_ && face_[0] == first; more_ = faces_.next(face_)) {
      edges_.push_back(edge_of(first, face_[1]).ends);
      edges_.push_back(edge_of(first, face_[2]).ends);
    }
    std::sort(edges_.begin(), edges_.end());
    return true;
  }

  FacesInTurn faces_;
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
  mesh.face_cursor(job).for_each(
      [&](const FaceVertices& face) { directions += directions_of(face); });
  return mesh.face_count > 0 && directions == 0;
}

namespace {

// each(u, v) for the edges that are not counted in turn.
template <typename Each>
void for_each_other_edge(const Job& job, const StoredMesh& mesh, const Each& each) {
  InTurn in_turn;
  mesh.face_cursor(job).for_each([&](const FaceVertices& face) {
    const auto [first, second, third] = lowest_first(face);
    each(second, third);
    if (in_turn(first)) return;
    each(first, second);
    each(first, third);
  });
}

// Edges that are not counted in turn, by their lower ends.
class EdgeLists {
 public:
  explicit EdgeLists(std::uint64_t vertices) : end_(vertices + 1, 0) {}

  static std::uint64_t bytes(std::uint64_t vertices, std::uint64_t edges) {
    return (vertices + 1 + edges) * sizeof(std::uint32_t);
  }

  // First all are counted, then all are added.
  void count(std::uint32_t u, std::uint32_t v) { ++end_[std::min(u, v) + std::size_t{1}]; }
  [[nodiscard]] std::uint64_t counted() const {
    return std::accumulate(end_.begin(), end_.end(), std::uint64_t{0});
  }
  void begin() {
    std::partial_sum(end_.begin(), end_.end(), end_.begin());
    ends_.resize(end_.back());
    std::copy_backward(end_.begin(), end_.end() - 1, end_.end());
    end_.front() = 0;
  }
  void add(std::uint32_t u, std::uint32_t v) {
    ends_[end_[std::min(u, v) + std::size_t{1}]++] = std::max(u, v);
  }

  [[nodiscard]] std::span<const std::uint32_t> higher_ends(std::size_t v) const {
    return {ends_.data() + end_[v], ends_.data() + end_[v + 1]};
  }

 private:
  std::vector<std::uint32_t> end_;  // of vertex v at v + 1, when all are added
  std::vector<std::uint32_t> ends_;
};

// Counts edges vertex by vertex: those that lead from it to higher ones, in any order.
class EdgesOfVertices {
 public:
  explicit EdgesOfVertices(std::uint64_t vertices) : met_(vertices, none) {}

  static std::uint64_t bytes(std::uint64_t vertices) { return vertices * sizeof(std::uint64_t); }

  // Of each vertex once, and then its edges. Without a branch on whether one was met before.
  void begin(std::uint64_t vertex) { vertex_ = vertex << count_bits; }
  void add(std::uint32_t higher) {
    const std::uint64_t before = met_[higher];
    const std::uint64_t times = (before & ~most) == vertex_ ? before & most : 0;
    met_[higher] = vertex_ | (times + (times < most ? 1 : 0));
    once_ += times == 0 ? 1 : 0;
    twice_ += times == 1 ? 1 : 0;
    three_times_ += times == 2 ? 1 : 0;
  }

  [[nodiscard]] SurfaceEdges edges() const { return {once_, once_ - twice_, three_times_}; }

 private:
  static constexpr unsigned count_bits = 2;
  static constexpr std::uint64_t most = 3;
  static constexpr std::uint64_t none = UINT64_MAX;

  std::vector<std::uint64_t> met_;  // by which vertex, and how often
  std::uint64_t vertex_ = 0;
  std::uint64_t once_ = 0, twice_ = 0, three_times_ = 0;  // edges that were met as often or more
};

// None where it takes more memory.
std::optional<SurfaceEdges> count_edges_in_memory(Job& job, const StoredMesh& mesh,
                                                  std::uint64_t memory) {
  const std::uint64_t vertices = mesh.vertices->size();
  const auto bytes = [vertices](std::uint64_t others) {
    return EdgesOfVertices::bytes(vertices) + EdgeLists::bytes(vertices, others);
  };
  // One edge a face, and few besides.
  if (bytes(mesh.face_count) > memory) return std::nullopt;
  const Reservation for_vertices = job.budget.reserve(bytes(0), "counting edges");
  EdgeLists others(vertices);
  for_each_other_edge(job, mesh, [&](std::uint32_t u, std::uint32_t v) { others.count(u, v); });
  const std::uint64_t counted = others.counted();
  if (counted > UINT32_MAX || bytes(counted) > memory) return std::nullopt;
  const Reservation for_others = job.budget.reserve(bytes(counted) - bytes(0), "counting edges");
  others.begin();
  for_each_other_edge(job, mesh, [&](std::uint32_t u, std::uint32_t v) { others.add(u, v); });
  EdgesOfVertices edges(vertices);
  std::uint64_t next = 0;
  const auto begin_to = [&](std::uint64_t end) {
    for (; next < end; ++next) {
      edges.begin(next);
      for (const std::uint32_t higher : others.higher_ends(next)) edges.add(higher);
    }
  };
  InTurn in_turn;
  mesh.face_cursor(job).for_each([&](const FaceVertices& face) {
    const auto [first, second, third] = lowest_first(face);
    if (!in_turn(first)) return;
    begin_to(first + std::uint64_t{1});
    edges.add(second);
    edges.add(third);
  });
  begin_to(vertices);
  return edges.edges();
}

SurfaceEdges count_edges(Job& job, const StoredMesh& mesh, std::uint64_t memory) {
  if (const auto counted = count_edges_in_memory(job, mesh, memory)) return *counted;
  const PartsPlan plan =
      PartedRecords<PackedEdge>::plan(memory, job.threads, mesh.face_count, sizeof(PackedEdge));
  PartedRecords<PackedEdge> others(job, plan);
  const std::uint64_t range = mesh.vertices->size() / plan.parts + 1;
  auto& lists = others.local();
  for_each_other_edge(job, mesh, [&](std::uint32_t u, std::uint32_t v) {
    lists.add(std::min(u, v) / range, edge_of(u, v));
  });
  EdgesInTurn turns(job, mesh);
  EdgeRuns runs;
  std::uint64_t next = 0;
  bool more = turns.next(next);
  others.for_each_stretch<std::vector<PackedEdge>>(
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
  return runs.finish();
}

double area_of(const FaceVertices& face, VertexIndex::Reader& vertices) {
  return length(doubled_area({vertices.position(face[0]), vertices.position(face[1]),
                              vertices.position(face[2])})) /
         2;
}

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
  {
    VertexIndex::Reader vertices(*mesh.vertices);
    std::uint64_t directions = 0;
    mesh.face_cursor(job).for_each([&](const FaceVertices& face) {
      if (joined) joined->add(face);
      if (!areas) return;
      out.area += area_of(face, vertices);
      directions += directions_of(face);
    });
    out.closed = areas && mesh.face_count > 0 && directions == 0;
  }
  job.progress.advance(mesh.face_count);
  if (joined) out.pieces = joined->pieces();
  joined.reset();
  for_joined.release();
  out.edges = count_edges(job, mesh, memory);
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

double area_of(const Job& job, const StoredMesh& mesh) {
  VertexIndex::Reader vertices(*mesh.vertices);
  double area = 0;
  mesh.face_cursor(job).for_each(
      [&](const FaceVertices& face) { area += area_of(face, vertices); });
  return area;
}

void note_lost_area(Job& job, const std::string& of, double before, double after, double part) {
  const double lost = 1 - after / before;
  if (lost > part) job.note(of + percentage(lost) + " of the area is gone");
}

std::string percentage(double part) {
  const double tenths = std::round(1000 * part) / 10;
  return shortest(tenths) + " %";
}

}  // namespace winnow
