#include "cluster/two_sided.hpp"

#include "base/hash.hpp"
#include "base/memory_shares.hpp"
#include "cluster/components.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace winnow {

namespace {

using MeshFace = FaceVertices;

// A face in the sense that it has in the mesh; the next number is the same face turned. Faces that
// cannot turn come first, so that they decide.
using SidedFace = std::uint64_t;

constexpr SidedFace two_sided = std::uint64_t{1} << 40;

SidedFace fixed_face(std::uint64_t place) {
  return 2 * place;
}
SidedFace two_sided_face(std::uint32_t first) {
  return 2 * (two_sided + first);
}

struct EdgeSide {
  std::uint32_t low, high;
  SidedFace face;  // as it passes the edge upwards

  static bool before(const EdgeSide& a, const EdgeSide& b) {
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.face < b.face;
  }
  static bool combine(EdgeSide& /*into*/, const EdgeSide& /*from*/) { return false; }
};

struct PlacedFace {
  SidedFace face;
  std::uint64_t place;

  static bool before(const PlacedFace& a, const PlacedFace& b) { return a.face < b.face; }
  static bool combine(PlacedFace& /*into*/, const PlacedFace& /*from*/) { return false; }
};

struct TurnedPlace {
  std::uint64_t place;

  static bool before(const TurnedPlace& a, const TurnedPlace& b) { return a.place < b.place; }
  static bool combine(TurnedPlace& /*into*/, const TurnedPlace& /*from*/) { return true; }
};

// Vertices of two-sided faces, and few others.
class Touched {
 public:
  void add(const MeshFace& face) {
    for (const std::uint32_t vertex : face) bits_[slot(vertex)] = true;
  }
  [[nodiscard]] bool has(std::uint32_t vertex) const { return bits_[slot(vertex)]; }

 private:
  static constexpr unsigned log_bits = 20;

  static std::size_t slot(std::uint32_t vertex) { return quick_hash(vertex) >> (64 - log_bits); }

  std::vector<bool> bits_ = std::vector<bool>(std::size_t{1} << log_bits);
};

// Calls each(place, face, two-sided face or null) for all faces of the mesh.
template <typename Each>
void for_each_face(const Job& job, const Spool& faces, const Spool& sided, const Each& each) {
  SpoolCursor<MeshFace> all(job, faces);
  SpoolCursor<TwoSidedFace> some(job, sided);
  TwoSidedFace next{};
  bool more = some.next(next);
  MeshFace face{};
  for (std::uint64_t place = 0; all.next(face); ++place) {
    const bool found = more && next.place == place;
    each(place, face, found ? &next : nullptr);
    if (found) more = some.next(next);
  }
}

void add_sides(SortedRecords<EdgeSide>& edges, const Touched& touched, const MeshFace& face,
               SidedFace upwards) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = face[i];
    const std::uint32_t b = face[(i + 1) % 3];
    if (!touched.has(a) || !touched.has(b)) continue;
    edges.add({std::min(a, b), std::max(a, b), upwards ^ (a < b ? 0U : 1U)});
  }
}

// Two faces agree if one passes their edge upwards and the other downwards.
void link_neighbours(Job& job, SortedRecords<EdgeSide>& edges, Components& components) {
  MergedCursor<EdgeSide> sorted = edges.merged();
  std::array<EdgeSide, 2> pair{};
  std::uint64_t of_edge = 0;
  const auto link = [&] {
    if (of_edge != 2 || pair[1].face < fixed_face(two_sided)) return;
    components.link(pair[0].face, pair[1].face ^ 1U);
    components.link(pair[0].face ^ 1U, pair[1].face);
  };
  std::uint64_t seen = 0;
  for (EdgeSide next{}; sorted.next(next); ++of_edge) {
    if (++seen % chunk_records == 0) job.progress.check_cancelled();
    if (of_edge > 0 && (next.low != pair[0].low || next.high != pair[0].high)) {
      link();
      of_edge = 0;
    }
    if (of_edge < 2) pair[of_edge] = next;
  }
  link();
}

// Calls turn(place) for each face that has to.
template <typename Turn>
void find_turned(Job& job, const Spool& faces, Components& components, std::uint64_t memory,
                 const Turn& turn) {
  SortedRecords<PlacedFace> turned(job, memory);
  // The lowest of each component stays as it is, and what agrees with it.
  components.finish([&](SidedFace first, SidedFace other) {
    if (first % 2 == 1 && other % 2 == 0) turned.add({other, 0});
  });
  SortedRecords<PlacedFace> places(job, memory);
  SpoolCursor<TwoSidedFace> cursor(job, faces);
  for (TwoSidedFace face{}; cursor.next(face);)
    places.add({two_sided_face(face.first), face.place});
  MergedCursor<PlacedFace> all = places.merged();
  MergedCursor<PlacedFace> some = turned.merged();
  PlacedFace at{};
  bool more = all.next(at);
  std::uint64_t seen = 0;
  for (PlacedFace next{}; some.next(next);) {
    for (; more && at.face < next.face; more = all.next(at)) {
      if (++seen % chunk_records == 0) job.progress.check_cancelled();
    }
    if (more && at.face == next.face) turn(at.place);
  }
}

void turn_faces(Job& job, MergedCursor<TurnedPlace>& turned, StoredMesh& mesh) {
  auto out = std::make_unique<Spool>(job, mesh.faces->memory_limit());
  Appender<MeshFace> append(job, *out);
  SpoolCursor<MeshFace> faces(job, *mesh.faces);
  TurnedPlace next{};
  bool more = turned.next(next);
  MeshFace face{};
  for (std::uint64_t place = 0; faces.next(face); ++place) {
    for (; more && next.place == place; more = turned.next(next)) std::swap(face[1], face[2]);
    append.add(face);
  }
  append.flush();
  out->finish();
  mesh.faces = std::move(out);
}

}  // namespace

void agree_on_sides(Job& job, const Spool& faces, std::uint64_t memory, StoredMesh& mesh) {
  if (faces.size() == 0) return;
  bool any = false;
  SortedRecords<TurnedPlace> turned(job, share::sides::turned(memory));
  {
    Components components(job, share::sides::components(memory));
    {
      Touched touched;
      for_each_face(job, *mesh.faces, faces,
                    [&](std::uint64_t /*place*/, const MeshFace& face, const TwoSidedFace* sided) {
                      if (sided != nullptr) touched.add(face);
                    });
      SortedRecords<EdgeSide> edges(job, share::sides::edges(memory));
      for_each_face(job, *mesh.faces, faces,
                    [&](std::uint64_t place, const MeshFace& face, const TwoSidedFace* sided) {
                      add_sides(
                          edges, touched, face,
                          sided != nullptr ? two_sided_face(sided->first) : fixed_face(place));
                    });
      link_neighbours(job, edges, components);
    }
    find_turned(job, faces, components, share::sides::labels(memory), [&](std::uint64_t place) {
      turned.add({place});
      any = true;
    });
  }
  if (!any) return;
  MergedCursor<TurnedPlace> places = turned.merged();
  turn_faces(job, places, mesh);
}

}  // namespace winnow
