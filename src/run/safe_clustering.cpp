#include "run/safe_clustering.hpp"

#include "base/memory_shares.hpp"
#include "base/sort_unique.hpp"
#include "cluster/batch_boxes.hpp"
#include "cluster/cell_set.hpp"
#include "cluster/exact_places.hpp"
#include "cluster/joined_mesh.hpp"
#include "cluster/near_faces.hpp"
#include "io/spool_records.hpp"
#include "stitch/damage.hpp"

#include <algorithm>
#include <array>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace winnow {

namespace {

// Where more than one in so many cells is damaged, or one in so many faces is near them, all faces
// are refined instead.
constexpr std::uint64_t most_damaged = 4;
constexpr std::uint64_t most_faces_near = 3;
// A cell that becomes damaged when others are split takes another look at all faces. So many looks.
constexpr unsigned most_rounds = 8;
// For so many cells a look leaves out what lies elsewhere.
constexpr std::size_t few_places = 256;
// Cells at a boundary draw it in by up to half of their size. They are split at least so deep, and
// until less than one part in so many of the area can go; to single positions where they are kept.
constexpr unsigned least_boundary_depth = 2;
constexpr std::uint64_t boundary_share = 100;

// A fold's vertex that goes is at most so many cells from the edge that stays: it had little of the
// surface.
constexpr double fold_reach = 0.5;

constexpr std::uint64_t tile_share = std::uint64_t{64} << 20;

// Of cells, or of parts of some.
using Names = std::vector<CellKey>;
using NamedFace = std::array<CellKey, 3>;

// Cells that are split further, the faces near them, and the mesh of these.
struct Level {
  Level(Job& job, std::size_t attributes, std::uint64_t memory)
      : split(job), beside(job), near(job, attributes, memory) {}

  CellSet split, beside;
  NearFaces near;
  ClusterResult result;
};

class DamageSplitter {
 public:
  DamageSplitter(Job& job, MeshReader& reader, const ClusterSettings& settings,
                 const ClusterMemory& memory, const Box& box, std::uint64_t faces,
                 ClusterResult coarse, std::unique_ptr<Spool> open)
      : job_(job),
        reader_(reader),
        settings_(settings),
        memory_(memory),
        faces_(faces),
        attributes_(settings.attributes.attributes.size()),
        names_(job, settings.grid, box),
        shift_(3 * names_.bits()),
        whole_(std::move(coarse)),
        open_cells_(std::move(open)),
        boxes_(job) {
    settings_.split = &names_;
    if (open_cells_ != nullptr && open_cells_->size() == 0) open_cells_.reset();
  }

  std::optional<SafeMesh> run() {
    std::optional<Names> damaged = damaged_cells();
    for (unsigned round = 0; damaged && !damaged->empty(); ++round) {
      if (round == most_rounds || names_.bits() == 0 ||
          names_.size() + damaged->size() > most_cells())
        return std::nullopt;
      damaged = split_all(*damaged);
    }
    if (!damaged) return std::nullopt;
    if (!whole_.folds.empty()) {
      const CellSet nothing(job_);
      join(whole_, shift_, Clusterer::make(job_, settings_, memory_)->finish(), nothing);
      shift_ = 0;
    }
    return SafeMesh{std::move(whole_), std::move(names_), shift_};
  }

 private:
  [[nodiscard]] bool keeps_boundaries() const { return open_cells_ != nullptr; }
  [[nodiscard]] std::uint64_t most_cells() const { return whole_.cells / most_damaged; }

  // Of the mesh as it was clustered; nothing where they are too many.
  std::optional<Names> damaged_cells() {
    if (record_count<CellKey>(*whole_.vanished) > most_cells()) return std::nullopt;
    if (keeps_boundaries() && record_count<CellKey>(*open_cells_) > most_cells())
      return std::nullopt;
    const std::optional<Damage> damage = look_at(whole_, most_cells());
    if (!damage) return std::nullopt;
    Names cells;
    SpoolCursor<CellKey> vanished(job_, *whole_.vanished);
    for (CellKey key = 0; vanished.next(key);) cells.push_back(names_.name_of(key));
    VertexIndex::Reader vertices(*whole_.mesh.vertices);
    for (const std::uint32_t v : damage->vertices)
      cells.push_back(names_.name_of(vertices.at(v).key));
    for (const std::uint32_t v : damage->at_boundaries)
      boundary_.push_back(names_.name_of(vertices.at(v).key));
    if (keeps_boundaries()) {
      SpoolCursor<CellKey> open(job_, *open_cells_);
      for (CellKey key = 0; open.next(key);) boundary_.push_back(names_.name_of(key));
      sort_unique(boundary_);
    }
    cells.insert(cells.end(), boundary_.begin(), boundary_.end());
    sort_unique(cells);
    return cells;
  }

  std::optional<Damage> look_at(ClusterResult& found, std::uint64_t most) {
    job_.progress.begin("look for damage", found.mesh.face_count, "faces");
    std::optional<Damage> damage =
        find_damage(job_, found.mesh, found.several.get(), most, fold_reach * settings_.grid.cell,
                    std::min(tile_share, share::left::damage(job_.budget.left())));
    if (!damage) return damage;
    found.folds.faces = std::move(damage->folds);
    VertexIndex::Reader vertices(*found.mesh.vertices);
    for (const std::uint32_t v : damage->folded) found.folds.vertices.push_back(vertices.at(v).key);
    return damage;
  }

  // Splits what is damaged, and the parts of it further that stay so, until no damage is left in
  // them. What else is damaged then. Nothing where damage stays, or too many faces are near.
  std::optional<Names> split_all(const Names& damaged) {
    split_boundaries();
    std::list<Level> levels;
    std::set<CellKey> damaged_beside;
    std::set<CellKey> unsettled;
    for (Names deeper = damaged; !deeper.empty();) {
      const bool first = levels.empty();
      Level& level = levels.emplace_back(
          job_, attributes_, share::split::near_faces(memory_.vertices) >> levels.size());
      for (const CellKey name : deeper) {
        level.split.set(names_.cell_of(name));
        if (first && std::binary_search(boundary_.begin(), boundary_.end(), name)) continue;
        names_.split_further(name);
      }
      if (first) {
        boundary_.clear();
        job_.progress.begin("read near damage", reader_.facts().faces.value_or(0), "faces");
        read_near(level, damaged);
        reader_.release_memory();
        if (level.near.size() > faces_ / most_faces_near) return std::nullopt;
      } else {
        level.near.take(std::prev(levels.end(), 2)->near, settings_.grid, level.split,
                        level.beside);
      }
      level.result = cluster_near(level, first ? whole_ : std::prev(levels.end(), 2)->result,
                                  first ? shift_ : 0);
      if (keeps_boundaries() &&
          !place_exactly(job_, level.near, names_, !settings_.double_positions,
                         share::split::positions(memory_.table),
                         share::split::vertices(memory_.vertices), level.result.mesh))
        return std::nullopt;
      deeper.clear();
      Names finest;
      look_around(level, deeper, finest, damaged_beside);
      for (const CellKey name : of_several_positions(level, finest)) unsettled.insert(name);
    }
    // What is damaged beside them may be the cause.
    if (damaged_beside.empty() && !unsettled.empty()) return std::nullopt;
    damaged_beside.merge(unsettled);
    // The last first: each takes the place of what it splits.
    while (!levels.empty()) {
      const Level& last = levels.back();
      const bool first = levels.size() == 1;
      ClusterResult& into = first ? whole_ : std::prev(levels.end(), 2)->result;
      join(into, first ? shift_ : 0, last.result, last.split);
      levels.pop_back();
    }
    shift_ = 0;
    return Names(damaged_beside.begin(), damaged_beside.end());
  }

  void join(ClusterResult& into, unsigned shift, const ClusterResult& parts, const CellSet& split) {
    into = joined(job_, into, shift, parts, names_, split, attributes_,
                  {memory_.vertices, memory_.result});
  }

  void read_near(Level& level, const Names& damaged) {
    const bool again = std::exchange(was_read_, true);
    if (!again || damaged.size() > few_places)
      return level.near.read(reader_, settings_.grid, level.split, level.beside, boxes_);
    std::vector<Box> places;
    for (const CellKey name : damaged) {
      // A cell more on each side makes up for all rounding.
      const SplitCells::Part part = names_.part_of(name);
      Box& box = places.emplace_back();
      for (const double side : {-1.0, 2.0}) {
        Point corner{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          corner[axis] =
              settings_.grid.origin[axis] + (part.cell[axis] + side) * settings_.grid.cell;
        box.add(corner);
      }
    }
    level.near.read_near(reader_, settings_.grid, level.split, level.beside, boxes_, places);
  }

  void split_boundaries() {
    sort_unique(boundary_);
    unsigned depth = keeps_boundaries() ? names_.bits() : least_boundary_depth;
    while (depth < names_.bits() && whole_.cells << depth < boundary_share * boundary_.size())
      ++depth;
    for (const CellKey name : boundary_) names_.split(names_.cell_of(name), depth);
  }

  // The faces near the level's cells; and of the mesh those that are not, but touch a cell beside
  // one, so that all faces around these are there.
  ClusterResult cluster_near(Level& level, const ClusterResult& around, unsigned shift) {
    const std::unique_ptr<Spool> ring = ring_of(level, around, shift);
    job_.progress.begin("split cells", level.near.size(), "faces");
    const std::unique_ptr<Clusterer> clusterer =
        Clusterer::make(job_, settings_, safe_memory(memory_));
    const FaceSink sink = [&](const FaceBatch& faces) {
      clusterer->add(faces);
      job_.progress.advance(faces.count);
    };
    while (level.near.for_each_batch(sink, [&] { return clusterer->wants_to_spill(); }))
      clusterer->spill();
    SpoolCursor<NamedFace> faces(job_, *ring);
    for (NamedFace face{}; faces.next(face);) {
      clusterer->add(face);
      if (clusterer->wants_to_spill()) clusterer->spill();
    }
    return clusterer->finish();
  }

  std::unique_ptr<Spool> ring_of(const Level& level, const ClusterResult& around, unsigned shift) {
    const StoredMesh& mesh = around.mesh;
    const std::uint64_t vertices = mesh.vertices->size();
    const Reservation reserved = job_.budget.reserve(vertices / 4 + 16, "cells beside damage");
    std::vector<bool> split(vertices, false);
    std::vector<bool> beside(vertices, false);
    SpoolCursor<IndexedVertex> cursor(job_, mesh.vertices->records());
    IndexedVertex vertex;
    for (std::uint64_t v = 0; cursor.next(vertex); ++v) {
      const PackedCell cell = names_.cell_of(vertex.key << shift);
      split[v] = level.split.has(cell);
      beside[v] = level.beside.has(cell);
    }
    auto ring = std::make_unique<Spool>(job_, share::split::ring(memory_.result));
    VertexIndex::Reader reader(*mesh.vertices);
    Appender<NamedFace> append(job_, *ring);
    SpoolCursor<FaceVertices> faces = mesh.face_cursor(job_);
    FoldedFaces folds(around.folds);
    for (FaceVertices face{}; faces.next(face);) {
      const auto [a, b, c] = face;
      if (folds.has(face)) continue;
      if (!(beside[a] || beside[b] || beside[c]) || split[a] || split[b] || split[c]) continue;
      append.add({reader.at(a).key << shift, reader.at(b).key << shift, reader.at(c).key << shift});
    }
    append.flush();
    ring->finish();
    return ring;
  }

  // Sorts what is damaged: what is to be split deeper, what cannot be, and what is beside, from
  // which that goes which is damaged no more.
  void look_around(Level& level, Names& deeper, Names& finest, std::set<CellKey>& damaged_beside) {
    const Damage damage = *look_at(level.result, UINT64_MAX);
    const std::uint64_t vertices = level.result.mesh.vertices->size();
    const Reservation reserved = job_.budget.reserve(vertices / 4 + 16, "parts of cells");
    std::vector<bool> split(vertices, false);
    std::vector<bool> known(vertices, false);  // with all faces around it
    const auto for_each_vertex = [&](const auto& each) {
      SpoolCursor<IndexedVertex> cursor(job_, level.result.mesh.vertices->records());
      IndexedVertex vertex;
      for (std::uint64_t v = 0; cursor.next(vertex); ++v) each(v, vertex.key);
    };
    for_each_vertex(
        [&](std::uint64_t v, CellKey name) { split[v] = level.split.has(names_.cell_of(name)); });
    SpoolCursor<FaceVertices> faces = level.result.mesh.face_cursor(job_);
    for (FaceVertices face{}; faces.next(face);) {
      const auto [a, b, c] = face;
      if (split[a] || split[b] || split[c]) known[a] = known[b] = known[c] = true;
    }
    if (!damaged_beside.empty()) {
      for_each_vertex([&](std::uint64_t v, CellKey name) {
        if (known[v] && !split[v]) damaged_beside.erase(name);
      });
    }
    const auto tell = [&](CellKey name) {
      if (!level.split.has(names_.cell_of(name))) {
        damaged_beside.insert(name);
      } else {
        (names_.part_of(name).depth < names_.bits() ? deeper : finest).push_back(name);
      }
    };
    SpoolCursor<CellKey> vanished(job_, *level.result.vanished);
    for (CellKey name = 0; vanished.next(name);) {
      if (level.split.has(names_.cell_of(name))) tell(name);
    }
    VertexIndex::Reader reader(*level.result.mesh.vertices);
    for (const std::uint32_t v : damage.vertices) {
      if (known[v]) tell(reader.at(v).key);
    }
    sort_unique(deeper);
  }

  // Of the names that are damaged at the finest depth those that hold several positions: at one
  // position, the input is damaged, too.
  Names of_several_positions(const Level& level, Names& names) {
    Names several;
    if (names.empty()) return several;
    std::sort(names.begin(), names.end());
    std::map<CellKey, Point> position;
    std::mutex mutex;
    level.near.for_each_batch([&](const FaceBatch& faces) {
      const std::scoped_lock lock(mutex);
      for (std::size_t i = 0; i < faces.count; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const Point corner = faces.corner(c, i);
          const std::optional<CellKey> name = names_.finest_part(corner);
          if (!name || !std::binary_search(names.begin(), names.end(), *name)) continue;
          if (position.emplace(*name, corner).first->second != corner) several.push_back(*name);
        }
      }
    });
    return several;
  }

  Job& job_;
  MeshReader& reader_;
  ClusterSettings settings_;
  ClusterMemory memory_;
  std::uint64_t faces_;
  std::size_t attributes_;
  SplitCells names_;
  unsigned shift_;  // of the keys of whole_, to names
  ClusterResult whole_;
  std::unique_ptr<Spool> open_cells_;  // null where boundaries may move
  BatchBoxes boxes_;
  bool was_read_ = false;
  Names boundary_;  // cells at boundaries, until they are split
};

}  // namespace

ClusterMemory safe_memory(ClusterMemory memory) {
  memory.vertices = share::split::vertices(memory.vertices);
  memory.result = share::split::result(memory.result);
  return memory;
}

std::optional<SafeMesh> without_damage(Job& job, MeshReader& reader,
                                       const ClusterSettings& settings, const ClusterMemory& memory,
                                       const Box& box, std::uint64_t faces, ClusterResult coarse,
                                       std::unique_ptr<Spool> open) {
  return DamageSplitter(job, reader, settings, memory, box, faces, std::move(coarse),
                        std::move(open))
      .run();
}

}  // namespace winnow
