#include "cluster/joined_mesh.hpp"

#include <winnow/error.hpp>

#include "base/cell_state.hpp"
#include "base/memory_shares.hpp"
#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "base/text.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

namespace {

using Numbers = FaceVertices;

// Vertices of a mesh in order, with what is beside them in other spools.
class VertexCursor {
 public:
  VertexCursor(const Job& job, const StoredMesh& mesh, std::size_t attributes)
      : vertices_(job, mesh.vertices->records()), carried(attributes) {
    if (mesh.state != nullptr) states_.emplace(job, *mesh.state);
    if (attributes > 0) attributes_.emplace(job, *mesh.attributes);
  }

  bool next() {
    if (!vertices_.next(vertex)) return false;
    ++read_;
    if (states_) states_->next(state);
    for (double& number : carried) attributes_->next(number);
    return true;
  }
  [[nodiscard]] std::uint64_t number() const { return read_ - 1; }

 private:
  std::uint64_t read_ = 0;
  SpoolCursor<IndexedVertex> vertices_;
  std::optional<SpoolCursor<CellState>> states_;
  std::optional<SpoolCursor<double>> attributes_;

 public:
  IndexedVertex vertex;
  CellState state;
  std::vector<double> carried;
};

// Of the vertices of one of two meshes that are merged: which are kept, and their numbers
// afterwards.
class BufferedVertices {
 public:
  static std::uint64_t memory(std::uint64_t vertices) {
    return vertices / 64 * sizeof(Block) + sizeof(Block);
  }

  explicit BufferedVertices(std::uint64_t vertices) : blocks_(vertices / 64 + 1) {}

  // In order, for those that are kept; `before`: how many vertices of the other mesh come before
  // it.
  void keep(std::uint64_t vertex, std::uint64_t before) {
    if (others_.empty() || others_.back().count != before) others_.push_back({kept_, before});
    Block& block = blocks_[vertex / 64];
    if (block.bits == 0) {
      block.kept = kept_;
      block.others = static_cast<std::uint32_t>(others_.size() - 1);
    }
    block.bits |= std::uint64_t{1} << (vertex % 64);
    ++kept_;
  }

  [[nodiscard]] bool has(std::uint64_t vertex) const {
    return (blocks_[vertex / 64].bits >> (vertex % 64) & 1) != 0;
  }

  // Of one that is kept.
  [[nodiscard]] std::uint32_t number(std::uint64_t vertex) const {
    const Block& block = blocks_[vertex / 64];
    const std::uint64_t below = (std::uint64_t{1} << (vertex % 64)) - 1;
    const std::uint64_t at =
        block.kept + static_cast<std::uint64_t>(std::popcount(block.bits & below));
    std::size_t i = block.others;
    while (i + 1 < others_.size() && others_[i + 1].kept <= at) ++i;
    return static_cast<std::uint32_t>(at + others_[i].count);
  }

 private:
  struct Block {
    std::uint64_t bits = 0;
    std::uint64_t kept = 0;    // before the block
    std::uint32_t others = 0;  // where others_ stands there
  };
  // From the vertex on that is kept as number `kept`, so many of the other mesh come before.
  struct Others {
    std::uint64_t kept, count;
  };
  std::vector<Block> blocks_;
  std::vector<Others> others_;
  std::uint64_t kept_ = 0;
};

// Whether a name is one of them; asked for names in ascending order.
class NamesInOrder {
 public:
  NamesInOrder(const std::vector<CellKey>& keys, unsigned shift) : keys_(keys), shift_(shift) {}

  bool has(CellKey name) {
    while (at_ < keys_.size() && keys_[at_] << shift_ < name) ++at_;
    return at_ < keys_.size() && keys_[at_] << shift_ == name;
  }

 private:
  const std::vector<CellKey>& keys_;
  unsigned shift_;
  std::size_t at_ = 0;
};

class Joiner {
 public:
  Joiner(Job& job, const ClusterResult& coarse, unsigned shift, const ClusterResult& fine,
         const SplitCells& names, const CellSet& split, std::size_t attributes,
         const MeshMemory& memory)
      : job_(job),
        coarse_(coarse),
        fine_(fine),
        names_(names),
        split_(split),
        shift_(shift),
        attributes_(attributes),
        reserved_(job.budget.reserve(BufferedVertices::memory(coarse.mesh.vertices->size()) +
                                         BufferedVertices::memory(fine.mesh.vertices->size()) +
                                         64 * split.size(),
                                     "joining parts of cells")),
        kept_coarse_(coarse.mesh.vertices->size()),
        kept_fine_(fine.mesh.vertices->size()),
        memory_(memory.faces),
        out_{{job, coarse.mesh.layout, {memory.vertices, share::split::joined(memory.faces)}}} {}

  ClusterResult run() {
    out_.cells = coarse_.cells;
    join_vertices();
    join_faces();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool splits(CellKey name) const { return split_.has(names_.cell_of(name)); }

  void join_vertices() {
    const bool states = coarse_.mesh.state != nullptr;
    Appender<IndexedVertex, VertexIndex> vertices(job_, *out_.mesh.vertices);
    VertexCursor coarse(job_, coarse_.mesh, attributes_);
    VertexCursor fine(job_, fine_.mesh, attributes_);
    NamesInOrder folded_coarse(coarse_.folds.vertices, shift_);
    NamesInOrder folded_fine(fine_.folds.vertices, 0);
    const auto next_coarse = [&] {
      if (!coarse.next()) return false;
      coarse.vertex.key <<= shift_;
      return true;
    };
    std::uint64_t from_coarse = 0;
    std::uint64_t from_fine = 0;
    bool more_coarse = next_coarse();
    bool more_fine = fine.next();
    while (more_coarse || more_fine) {
      const CellKey name = std::min(more_coarse ? coarse.vertex.key : UINT64_MAX,
                                    more_fine ? fine.vertex.key : UINT64_MAX);
      const bool in_coarse = more_coarse && coarse.vertex.key == name;
      const bool in_fine = more_fine && fine.vertex.key == name;
      const bool split = splits(name);
      const bool take_coarse = in_coarse && !split && !folded_coarse.has(name);
      const bool take_fine = in_fine && (split || !take_coarse);
      if ((take_coarse || take_fine) && !folded_fine.has(name)) {
        const VertexCursor& from = take_fine ? fine : coarse;
        vertices.add(from.vertex);
        if (states) append_records<CellState>(*out_.mesh.state, std::span(&from.state, 1));
        if (attributes_ > 0) append_records<double>(*out_.mesh.attributes, from.carried);
        if (take_fine) {
          kept_fine_.keep(fine.number(), from_coarse);
          ++from_fine;
        } else {
          kept_coarse_.keep(coarse.number(), from_fine);
          ++from_coarse;
        }
      }
      if (in_coarse) more_coarse = next_coarse();
      if (in_fine) more_fine = fine.next();
    }
    vertices.flush();
    out_.mesh.finish_vertices();
    if (out_.mesh.vertices->size() > UINT32_MAX) {
      throw Error(ErrorKind::failed,
                  "the result has " + grouped(out_.mesh.vertices->size()) +
                      " vertices, more than output formats can count; choose fewer faces");
    }
  }

  // chosen(face, new numbers) for the faces of a mesh, from several threads: whether it counts.
  template <typename Chosen>
  std::unique_ptr<Spool> renumbered(const ClusterResult& from, std::uint64_t memory,
                                    const Chosen& chosen) {
    auto faces = std::make_unique<Spool>(job_, memory);
    struct Chunk {
      std::vector<Numbers> old, now;
    };
    std::uint64_t next = 0;
    pipeline<Chunk>(
        2 * std::size_t{job_.threads},
        [&](Chunk& chunk) {
          const std::uint64_t count =
              std::min<std::uint64_t>(chunk_records, from.mesh.face_count - next);
          chunk.old = from.mesh.read_faces(next, count);
          next += count;
          job_.progress.check_cancelled();
          return count > 0;
        },
        [&](Chunk& chunk) {
          chunk.now.clear();
          FoldedFaces folds(from.folds);
          for (const Numbers& face : chunk.old) {
            Numbers now{};
            if (!folds.has(face) && chosen(face, now)) chunk.now.push_back(now);
          }
        },
        [&](const Chunk& chunk) { append_records<Numbers>(*faces, chunk.now); });
    faces->finish();
    return faces;
  }

  // New numbers rise with the old ones, so faces stay in order.
  void join_faces() {
    const std::unique_ptr<Spool> coarse = renumbered(coarse_, share::split::kept_coarse(memory_),
                                                     [&](const Numbers& face, Numbers& now) {
                                                       for (std::size_t i = 0; i < 3; ++i) {
                                                         if (!kept_coarse_.has(face[i]))
                                                           return false;
                                                         now[i] = kept_coarse_.number(face[i]);
                                                       }
                                                       return true;
                                                     });
    struct Readers {
      Readers(const VertexIndex& from, const VertexIndex& to) : old(from), now(to) {}
      VertexIndex::Reader old, now;
    };
    PerSlot<Readers> readers(job_.threads, [&] {
      return std::make_unique<Readers>(*fine_.mesh.vertices, *out_.mesh.vertices);
    });
    const std::unique_ptr<Spool> fine =
        renumbered(fine_, share::split::kept_fine(memory_), [&](const Numbers& face, Numbers& now) {
          if (!kept_fine_.has(face[0]) && !kept_fine_.has(face[1]) && !kept_fine_.has(face[2]))
            return false;
          for (std::size_t i = 0; i < 3; ++i) {
            if (kept_fine_.has(face[i])) {
              now[i] = kept_fine_.number(face[i]);
            } else {
              Readers& reader = readers.local();
              now[i] =
                  static_cast<std::uint32_t>(reader.now.find(reader.old.at(face[i]).key).number);
            }
          }
          return true;
        });
    Appender<Numbers> append(job_, *out_.mesh.faces);
    SpoolCursor<Numbers> from_coarse(job_, *coarse);
    SpoolCursor<Numbers> from_fine(job_, *fine);
    Numbers a{};
    Numbers b{};
    bool more_a = from_coarse.next(a);
    bool more_b = from_fine.next(b);
    for (; more_a || more_b; ++out_.mesh.face_count) {
      const bool take_b = !more_a || (more_b && b < a);
      append.add(take_b ? b : a);
      (take_b ? more_b : more_a) = take_b ? from_fine.next(b) : from_coarse.next(a);
    }
    append.flush();
    out_.mesh.finish_faces();
  }

  Job& job_;
  const ClusterResult& coarse_;
  const ClusterResult& fine_;
  const SplitCells& names_;
  const CellSet& split_;
  unsigned shift_;
  std::size_t attributes_;
  Reservation reserved_;
  BufferedVertices kept_coarse_, kept_fine_;
  std::uint64_t memory_;  // for faces
  ClusterResult out_;
};

}  // namespace

ClusterResult joined(Job& job, const ClusterResult& coarse, unsigned shift,
                     const ClusterResult& fine, const SplitCells& names, const CellSet& split,
                     std::size_t attributes, const MeshMemory& memory) {
  return Joiner(job, coarse, shift, fine, names, split, attributes, memory).run();
}

}  // namespace winnow
