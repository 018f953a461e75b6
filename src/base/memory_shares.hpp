// How each component divides the memory that it is given. Shares of one group are held at once: the
// compiler checks that they are not more than the whole.
#pragma once

#include <cstdint>

namespace winnow {

struct Share {
  std::uint64_t parts, of;

  constexpr std::uint64_t operator()(std::uint64_t memory) const {
    return memory / of * parts + memory % of * parts / of;
  }
  // Of which `bytes` are the share.
  [[nodiscard]] constexpr std::uint64_t whole(std::uint64_t bytes) const {
    return bytes * of / parts;
  }
};

template <typename... Shares>
consteval bool fit(Shares... shares) {
  constexpr std::uint64_t common = 960;
  return ((shares.parts * common / shares.of) + ...) <= common;
}

namespace share {

// The budget, without what threads and blocks in flight take. What moved by welding is taken off
// before.
namespace plan {
inline constexpr Share cells{3, 8}, faces{1, 4}, input_vertices{1, 4}, merging{1, 8};
static_assert(fit(cells, faces, input_vertices, merging));
// The vertices of the input make room for those of the result, and cells for its faces.
inline constexpr Share vertices{1, 4}, result{1, 4};
inline constexpr Share moved{1, 4};
inline constexpr Share weld_sorting{1, 4}, weld_links{1, 8}, weld_positions{1, 8};
static_assert(fit(weld_sorting, weld_sorting, weld_links, weld_positions));
}  // namespace plan

// What `info` has beside its threads.
namespace info {
inline constexpr Share reading{1, 8}, edges{3, 8}, pieces{1, 2};
static_assert(fit(reading, edges, pieces));
}  // namespace info

// What `compare` has left: of the simplified mesh, then of the original.
namespace compare {
inline constexpr Share reading_simplified{1, 8}, reading_original{1, 4};
}  // namespace compare

// What is left of the budget while nothing else grows.
namespace left {
inline constexpr Share added_mesh{1, 4};    // that a program makes; it is read as a file afterwards
inline constexpr Share checking{1, 2};      // the result
inline constexpr Share map{1, 16};          // where the input's vertices went
inline constexpr Share used{1, 4};          // bits for vertices, while it is made
inline constexpr Share sorting_used{1, 4};  // of those behind, of what these left
inline constexpr Share packing{1, 2};       // blocks of the output
inline constexpr Share damage{1, 2};        // tiles that are looked at, and as much for sorting
inline constexpr Share crowded_part{1, 2};  // records of one part that are more than expected
inline constexpr Share samples{1, 16};      // of the original, while it is refined
}  // namespace left

// A mesh file that has vertices of its own: the part for vertices.
namespace reading {
inline constexpr Share buffered_vertices{1, 2}, buffered_faces{3, 8}, buffered_numbers{1, 8};
static_assert(fit(buffered_vertices, buffered_faces, buffered_numbers));
inline constexpr Share faces_first{1, 4};  // of a PLY, while its vertices are awaited
inline constexpr Share fans{1, 8};         // of buffered faces
inline constexpr Share touched{1, 2};      // pages of mapped vertices, before they are dropped
inline constexpr Share one_batch{1, 4};    // of them, that faces of one batch may touch
inline constexpr Share sorted_part{1, 8}, near_faces{1, 16};
inline constexpr Share corner_part{1, 2}, corner_chunks{1, 4}, corner_batches{1, 2};
}  // namespace reading

// Records that are sorted part by part.
namespace parted {
inline constexpr Share first_chunks{1, 3}, sorting{1, 2};
static_assert(fit(first_chunks, sorting));
}  // namespace parted

// Clustering: of the part for faces, of that for vertices, of that for the result.
namespace cluster {
inline constexpr Share boundaries{1, 8};  // their sums, or the cells that they pass through
inline constexpr Share open_sums{7, 8}, open_cells{1, 8};  // of these cells
static_assert(fit(open_sums, open_cells));
inline constexpr Share vanished{1, 16};
inline constexpr Share several{1, 16};
}  // namespace cluster

// Splitting damaged cells. While parts of cells are clustered there are four meshes at most.
namespace split {
inline constexpr Share vertices{1, 4}, result{1, 4};
inline constexpr Share near_faces{1, 2};  // of vertices, at the first level; half of it at the next
inline constexpr Share ring{1, 16};       // of the result
inline constexpr Share positions{1, 8};   // of cells, when parts have been clustered
inline constexpr Share joined{1, 2}, kept_coarse{1, 4}, kept_fine{1, 4};
static_assert(fit(joined, kept_coarse, kept_fine));
}  // namespace split

// Welding: of the part for lists, of that for faces; of what moved.
namespace weld {
inline constexpr Share numbers{1, 2};
inline constexpr Share two_sided{1, 16};
inline constexpr Share moved_from{2, 3}, moved_to{1, 3};
static_assert(fit(moved_from, moved_to));
}  // namespace weld

// Agreeing on the sides of faces.
namespace sides {
inline constexpr Share turned{1, 8}, components{1, 4}, edges{1, 2};
static_assert(fit(turned, components, edges));
inline constexpr Share labels{1, 4};  // when the edges are gone
}  // namespace sides

// Links of connected parts: a list that is filled, and one that is read.
namespace components {
inline constexpr Share links{1, 2};
static_assert(fit(links, links));
}  // namespace components

// Refinement, of what the clustered mesh leaves. There is a mesh that goes into a round, and one
// that comes out.
namespace refine {
inline constexpr Share tiles{1, 2}, logs{1, 8}, mesh{1, 8}, lists{1, 8};
static_assert(fit(tiles, logs, mesh, mesh, lists));
inline constexpr Share attempt{1, 2};             // of logs: two attempts may be there at once
inline constexpr Share edges{1, 2}, costs{1, 2};  // of an attempt
inline constexpr Share boxes{1, 4};               // of lists, while faces are unfolded
inline constexpr Share incoming{1, 2}, sorting_incoming{1, 2};
static_assert(fit(incoming, sorting_incoming));
inline constexpr Share renumbering{1, 2}, sorting_vertices{1, 2};  // of lists, while reordering
static_assert(fit(renumbering, sorting_vertices));
inline constexpr Share joined{1, 2};  // of lists, while vertices are joined
}  // namespace refine

// Fitting, of what refinement has for tiles, while samples look for their faces.
namespace fitting {
inline constexpr Share index{1, 2}, hits{1, 4}, placed{3, 16}, reading{1, 16};
static_assert(fit(index, hits, placed, reading));
}  // namespace fitting

// What comes out of a round: the mesh, and faces on their way to it.
namespace round {
inline constexpr Share mesh{3, 4};
inline constexpr Share inner_faces{3, 32}, seam_faces{1, 32}, hub_faces{1, 32}, named{1, 32},
    sorted_hub_faces{1, 32};
// Where vertices went: in the round, and before and after that.
inline constexpr Share map{1, 96};
static_assert(fit(mesh, inner_faces, seam_faces, hub_faces, named, sorted_hub_faces, map, map,
                  map));
inline constexpr Share hub_normals{1, 32};  // when the faces have their numbers
}  // namespace round

// Counting what a mesh has.
namespace count {
inline constexpr Share joined_vertices{1, 2};
inline constexpr Share links{1, 5};
inline constexpr Share least_beside_merging{1, 8};
}  // namespace count

}  // namespace share

}  // namespace winnow
