#include "cluster/welder.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/pages.hpp"
#include "base/per_slot.hpp"
#include "base/rounding.hpp"
#include "base/text.hpp"
#include "cluster/area_sum.hpp"
#include "cluster/resolution.hpp"
#include "cluster/two_sided.hpp"
#include "cluster/weld_lattice.hpp"
#include "cluster/written_rounding.hpp"
#include "io/parted_records.hpp"
#include "io/spool_records.hpp"
#include "read/for_each_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// All faces of three vertices, whose numbers ascend. For each sense, along that order (an even
// permutation of it) and against it: how many faces have it, and the number of the first one in the
// input (low 32 bits).
struct WeldedFaces {
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 2> count;  // at most 2^32 - 1
  std::array<std::uint32_t, 2> first;

  void add(const WeldedFaces& more) {
    for (std::size_t sense = 0; sense < 2; ++sense) {
      const std::uint64_t sum = std::uint64_t{count[sense]} + more.count[sense];
      count[sense] = static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, UINT32_MAX));
      first[sense] = std::min(first[sense], more.first[sense]);
    }
  }

  [[nodiscard]] bool joins(const WeldedFaces& other) const {
    return vertex[0] == other.vertex[0] && vertex[1] == other.vertex[1] &&
           vertex[2] == other.vertex[2];
  }
  [[nodiscard]] bool balanced() const { return count[0] == count[1]; }
  [[nodiscard]] bool against() const {
    return balanced() ? first[1] < first[0] : count[0] < count[1];
  }
};

// A face on its way there, from its lowest vertex on.
struct NumberedCorners {
  std::array<std::uint32_t, 3> vertex;
  std::uint32_t face;  // low 32 bits of its number

  [[nodiscard]] bool against() const { return vertex[1] > vertex[2]; }
  [[nodiscard]] std::array<std::uint32_t, 3> ascending() const {
    if (against()) return {vertex[0], vertex[2], vertex[1]};
    return vertex;
  }
  [[nodiscard]] std::uint64_t rank() const { return vertex[0]; }
  static bool before(const NumberedCorners& a, const NumberedCorners& b) {
    const auto [a0, a1, a2] = a.ascending();
    const auto [b0, b1, b2] = b.ascending();
    if (a0 != b0) return a0 < b0;
    return a1 != b1 ? a1 < b1 : a2 < b2;
  }
  static bool combine(NumberedCorners& /*into*/, const NumberedCorners& /*from*/) { return false; }
};

NumberedCorners from_lowest(const std::array<std::uint32_t, 3>& vertex, std::uint32_t face) {
  const auto [a, b, c] = vertex;
  if (a < b && a < c) return {{a, b, c}, face};
  if (b < c) return {{b, c, a}, face};
  return {{c, a, b}, face};
}

WeldedFaces welded_face(const NumberedCorners& corners) {
  WeldedFaces out{corners.ascending(), {}, {UINT32_MAX, UINT32_MAX}};
  const std::size_t sense = corners.against() ? 1 : 0;
  out.count[sense] = 1;
  out.first[sense] = corners.face;
  return out;
}

// A position, and the low 32 bits of the number that the input gives it. Of floats where all are.
template <typename Real>
struct NumberedPosition {
  CellKey key;
  std::array<Real, 3> at;
  std::uint32_t number;

  [[nodiscard]] std::uint64_t rank() const { return key; }
  [[nodiscard]] Point position() const { return {at[0], at[1], at[2]}; }
  static bool before(const NumberedPosition& a, const NumberedPosition& b) {
    return a.key != b.key ? a.key < b.key : a.at < b.at;
  }
  static bool combine(NumberedPosition& /*into*/, const NumberedPosition& /*from*/) {
    return false;
  }
};

// The ranges of keys that hold about as many of some keys each.
class KeyRanges {
 public:
  KeyRanges(std::vector<CellKey> some, std::size_t ranges) {
    std::sort(some.begin(), some.end());
    for (std::size_t i = 1; i < ranges && !some.empty(); ++i)
      begin_.push_back(some[i * some.size() / ranges]);
  }

  [[nodiscard]] std::size_t of(CellKey key) const {
    return static_cast<std::size_t>(std::upper_bound(begin_.begin(), begin_.end(), key) -
                                    begin_.begin());
  }

 private:
  std::vector<CellKey> begin_;  // of all but the first
};

// The numbers of the vertices that the input's positions became, where there is room for them.
class VertexNumbers {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  VertexNumbers() = default;
  VertexNumbers(Job& job, std::uint64_t positions, std::uint64_t memory) {
    if (positions == 0 || positions > UINT32_MAX || positions * sizeof(none) > memory) return;
    pages_ = Pages::try_allocate(job.budget, positions * sizeof(none));
    if (pages_) std::fill(numbers().begin(), numbers().end(), none);
  }

  explicit operator bool() const { return static_cast<bool>(pages_); }
  [[nodiscard]] std::uint64_t bytes() const { return pages_.size(); }
  void set(std::uint64_t position, std::uint32_t number) {
    if (position < numbers().size()) numbers()[position] = number;
  }
  [[nodiscard]] std::uint32_t of(std::uint64_t position) const {
    return position < numbers().size() ? numbers()[position] : none;
  }

 private:
  [[nodiscard]] std::span<std::uint32_t> numbers() const { return pages_.as<std::uint32_t>(); }

  Pages pages_;
};

// Reads the positions. Fills mesh.vertices and, where the input numbers them, `numbers`.
template <typename Real>
void weld_vertices(Job& job, MeshReader& reader, const Grid& grid, const MostPositions& most,
                   std::uint64_t positions, const WeldMemory& memory, VertexNumbers& numbers,
                   StoredMesh& mesh) {
  using Position = NumberedPosition<Real>;
  job.progress.begin("weld", reader.facts().vertices.value_or(0), "positions");
  const PartsPlan plan =
      PartedRecords<Position>::plan(memory.lists, job.threads, positions, sizeof(IndexedVertex));
  std::vector<CellKey> keys;
  for (const Point& p : most.picked) keys.push_back(key_of(grid, p));
  const KeyRanges ranges(std::move(keys), plan.parts);
  PartedRecords<Position> records(job, plan);
  PerSlot<RecentPositions> recent(job.threads, [] { return std::make_unique<RecentPositions>(); });
  PerSlot<WrittenRounding> written(job.threads, [] { return std::make_unique<WrittenRounding>(); });
  for_each_position_batch(job, reader, [&](const PositionView& view) {
    auto& lists = records.local();
    WrittenRounding& digits = written.local();
    RecentPositions& seen = recent.local();
    for (std::size_t i = 0; i < view.count; ++i) {
      const Point p = without_minus_zero({view.axis[0][i], view.axis[1][i], view.axis[2][i]});
      if (!finite(p)) continue;
      if constexpr (std::is_same_v<Real, double>) {
        for (const double coordinate : p) digits.add(coordinate);
      }
      if (!numbers && !seen.add(p)) continue;
      const CellKey key = key_of(grid, p);
      lists.add(ranges.of(key),
                {key,
                 {static_cast<Real>(p[0]), static_cast<Real>(p[1]), static_cast<Real>(p[2])},
                 static_cast<std::uint32_t>(view.first + i)});
    }
  });
  reader.release_memory();
  mesh.rounding = coordinate_rounding(std::is_same_v<Real, float>);
  if constexpr (std::is_same_v<Real, double>) {
    WrittenRounding all;
    for (const WrittenRounding* seen : written.all()) all.add(*seen);
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      largest = std::max({largest, std::abs(most.box.low[axis]), std::abs(most.box.high[axis])});
    mesh.rounding = all.rounding(most.box.longest_side(), largest);
  }

  struct Stretch {
    std::vector<IndexedVertex> vertices;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> places;  // of a number, in `vertices`
  };
  Point last{NAN, NAN, NAN};
  records.template for_each_stretch<Stretch>(
      [&](std::span<const Position> sorted, Stretch& out) {
        out.vertices.clear();
        out.places.clear();
        for (const Position& record : sorted) {
          const Point position = record.position();
          if (out.vertices.empty() || out.vertices.back().position != position) {
            out.vertices.emplace_back();
            out.vertices.back().key = record.key;
            out.vertices.back().position = position;
          }
          if (numbers)
            out.places.emplace_back(record.number,
                                    static_cast<std::uint32_t>(out.vertices.size() - 1));
        }
      },
      [&](const Stretch& out) {
        const std::size_t again = out.vertices.front().position == last ? 1 : 0;
        const std::uint64_t first = mesh.vertices->size() - again;
        mesh.vertices->append(std::span(out.vertices).subspan(again));
        last = out.vertices.back().position;
        for (const auto& [number, place] : out.places)
          numbers.set(number, static_cast<std::uint32_t>(first + place));
      });
  mesh.vertices->finish();
  if (mesh.vertices->size() > UINT32_MAX) {
    throw Error(ErrorKind::failed, "the input has " + grouped(mesh.vertices->size()) +
                                       " different positions, more than one mesh can number; "
                                       "`detail` 6 clusters them");
  }
}

// Two-sided faces go to `sided`, too.
void collect_faces(Job& job, PartedRecords<NumberedCorners>& faces, Spool& sided,
                   WeldResult& result) {
  StoredMesh& mesh = result.mesh;
  Appender<FaceVertices> append(job, *mesh.faces);
  Appender<TwoSidedFace> append_sided(job, sided);
  VertexIndex::Reader vertices(*mesh.vertices);
  const auto has_area = [&](const std::array<std::uint32_t, 3>& face) {
    Triangle corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = vertices.at(face[i]).position;
    return !thinner_than_rounding(corners, doubled_area(corners), *mesh.rounding);
  };
  const auto settle = [&](const WeldedFaces& face) {
    if (face.balanced() && !has_area(face.vertex)) {
      result.flat_pairs += face.count[0];
      return;
    }
    const auto [a, b, c] = face.vertex;
    if (face.balanced())
      append_sided.add({mesh.face_count, std::min(face.first[0], face.first[1])});
    append.add(face.against() ? std::array{a, c, b} : face.vertex);
    result.fused += std::min(face.count[0], face.count[1]);
    ++mesh.face_count;
  };
  std::optional<WeldedFaces> last;  // more of it may come
  faces.for_each_stretch<std::vector<WeldedFaces>>(
      [](std::span<const NumberedCorners> sorted, std::vector<WeldedFaces>& out) {
        out.clear();
        for (const NumberedCorners& corners : sorted) {
          const WeldedFaces face = welded_face(corners);
          if (!out.empty() && out.back().joins(face)) {
            out.back().add(face);
          } else {
            out.push_back(face);
          }
        }
      },
      [&](const std::vector<WeldedFaces>& out) {
        for (const WeldedFaces& face : out) {
          if (last && last->joins(face)) {
            last->add(face);
            continue;
          }
          if (last) settle(*last);
          last = face;
        }
      });
  if (last) settle(*last);
  append.flush();
  mesh.finish_faces();
  append_sided.flush();
  sided.finish();
}

void collect_attributes(Job& job, AttributeMeans& means, StoredMesh& mesh) {
  const std::unique_ptr<AttributeCursor> cursor = means.finish();
  const std::size_t carried = mesh.layout.attributes;
  const std::uint64_t vertices = mesh.vertices->size();
  std::vector<double> chunk;
  for (std::uint64_t v = 0; v < vertices; ++v) {
    chunk.resize(chunk.size() + carried);
    cursor->find(v, std::span(chunk).last(carried));
    if (chunk.size() < carried * chunk_records && v + 1 < vertices) continue;
    mesh.attributes->append(std::as_bytes(std::span(chunk)));
    chunk.clear();
    job.progress.check_cancelled();
  }
  mesh.attributes->finish();
}

}  // namespace

WeldResult weld(Job& job, MeshReader& reader, const WeldSettings& settings, WeldMemory memory,
                std::uint64_t available) {
  const CarriedAttributes& attributes = settings.attributes;
  WeldResult result;
  StoredMesh& mesh = result.mesh;
  const std::uint64_t positions = reader.facts().vertices.value_or(available);
  const MostPositions most = measure_most(job, reader, positions);
  if (most.box.empty) return result;
  mesh = {job, {0, attributes.attributes.size()}, {memory.vertices, memory.faces}};
  const Grid grid = lattice_over(most.box);
  if (settings.lattice != nullptr) *settings.lattice = grid;
  // A third of what the lists would take, on a surface.
  VertexNumbers numbers(job, reader.facts().vertices.value_or(0),
                        share::weld::numbers(memory.lists));
  memory.lists -= numbers.bytes();
  if (reader.facts().double_positions) {
    weld_vertices<double>(job, reader, grid, most, positions, memory, numbers, mesh);
  } else {
    weld_vertices<float>(job, reader, grid, most, positions, memory, numbers, mesh);
  }
  if (settings.single)
    mesh.rounding->relative = std::max(mesh.rounding->relative, rounding_of_float);

  job.progress.begin("join faces", reader.facts().faces.value_or(0), "faces");
  const PartsPlan plan = PartedRecords<NumberedCorners>::plan(memory.lists, job.threads, available,
                                                              sizeof(WeldedFaces));
  auto faces = std::make_unique<PartedRecords<NumberedCorners>>(job, plan);
  const std::uint64_t range = mesh.vertices->size() / plan.parts + 1;
  // Faces as small as those of a scan are added up fast.
  const double unit = most.box.longest_side() / 4096;
  AreaSum area(job.threads, unit * unit);
  std::unique_ptr<AttributeMeans> means;
  if (!attributes.empty())
    means = AttributeMeans::make(job, attributes, AttributeMeans::Keys::numbers, memory.attributes);
  struct Worker {
    explicit Worker(const VertexIndex& index) : vertices(index) {}
    VertexIndex::Reader vertices;
    ClusterCounts counts;
  };
  PerSlot<Worker> workers(job.threads, [&] { return std::make_unique<Worker>(*mesh.vertices); });
  reader.begin_faces();
  const auto stop = [&] { return means != nullptr && means->wants_to_spill(); };
  while (for_each_face_batch(
      job, reader,
      [&](const FaceBatch& batch) {
        Worker& worker = workers.local();
        auto& lists = faces->local();
        area.add(batch);
        const GoodFaces good(batch);
        ClusterCounts here;
        here.faces = batch.count;
        here.bad = good.bad();
        here.cropped = good.cropped();
        here.first_bad = good.first_bad();
        worker.counts.add(here);
        for (const NumberedFace& face : good.faces()) {
          const std::size_t place = face.number - batch.first;
          std::array<std::uint32_t, 3> number{};
          for (std::size_t i = 0; i < 3; ++i) {
            const Point p = without_minus_zero(face.corner[i]);
            number[i] = numbers
                            ? numbers.of(batch.first_vertex + batch.index[i][place])
                            : static_cast<std::uint32_t>(worker.vertices.find(key_of(grid, p), p));
            if (number[i] == VertexNumbers::none)
              throw Error(ErrorKind::bad_input, "the input was changed while it was read");
          }
          const NumberedCorners corners = from_lowest(number, batch.number(place));
          lists.add(corners.vertex[0] / range, corners);
          if (means != nullptr) means->add(batch, place, {number[0], number[1], number[2]});
        }
      },
      stop)) {
    means->spill();
  }
  for (const Worker* worker : workers.all()) result.counts.add(worker->counts);
  if (settings.area != nullptr) *settings.area = area.value();
  reader.release_memory();
  numbers = {};
  Spool sided(job, share::weld::two_sided(memory.faces));
  collect_faces(job, *faces, sided, result);
  faces.reset();
  agree_on_sides(job, sided, memory.lists, mesh);
  if (means != nullptr) collect_attributes(job, *means, mesh);
  return result;
}

}  // namespace winnow
