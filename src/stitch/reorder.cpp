#include "stitch/reorder.hpp"

#include "base/memory_shares.hpp"
#include "io/inverse_numbers.hpp"
#include "io/recent_blocks.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "mesh/ordered_face.hpp"
#include "mesh/vertex_map.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

namespace winnow {

namespace {

constexpr std::uint32_t third = axis_cells / 3;

CellKey shifted(CellKey key, bool back) {
  std::array<std::uint32_t, 3> cell = morton_cell(key);
  for (std::uint32_t& x : cell) x = (x + (back ? axis_cells - third : third)) % axis_cells;
  return morton_key(cell[0], cell[1], cell[2]);
}

struct Moved {
  CellKey key;  // the new one
  std::uint32_t old_number;
  std::uint32_t unused;

  static bool before(const Moved& a, const Moved& b) {
    return a.key != b.key ? a.key < b.key : a.old_number < b.old_number;
  }
  static bool combine(Moved&, const Moved&) { return false; }
};

}  // namespace

StoredMesh reorder(Job& job, StoredMesh whole, bool back, std::uint64_t list_memory,
                   std::uint64_t mesh_memory) {
  const std::uint64_t vertices = whole.vertices->size();
  const MeshLayout layout = whole.layout;
  StoredMesh out(job, layout, MeshMemory::divide(mesh_memory));
  out.face_count = whole.face_count;
  Spool numbers(job, share::refine::renumbering(list_memory));  // the new number of each vertex
  {
    InverseNumbers renumbered(job, vertices, share::refine::renumbering(list_memory));
    {
      SortedRecords<Moved> in_order(job, share::refine::sorting_vertices(list_memory));
      VertexIndex::Reader reader(*whole.vertices);
      for (std::uint32_t v = 0; v < vertices; ++v)
        in_order.add({shifted(reader.at(v).key, back), v, 0});
      MergedCursor<Moved> merged = in_order.merged();
      Appender<IndexedVertex, VertexIndex> append(job, *out.vertices);
      std::optional<RecentBlocks> state, carried;
      if (layout.state > 0) state.emplace(*whole.state, layout.state);
      if (layout.attributes > 0) carried.emplace(*whole.attributes, layout.attribute_bytes());
      for (Moved moved{}; merged.next(moved);) {
        renumbered.add(moved.old_number);
        IndexedVertex vertex = reader.at(moved.old_number);
        vertex.key = moved.key;
        append.add(vertex);
        if (state) out.state->append(state->record(moved.old_number));
        if (carried) out.attributes->append(carried->record(moved.old_number));
      }
      append.flush();
    }
    renumbered.append_to(numbers);
    numbers.finish();
  }
  if (whole.map != nullptr)
    out.map = composed(job, *whole.map, numbers, share::round::map(mesh_memory));
  out.finish_vertices();
  whole.vertices.reset();
  whole.attributes.reset();
  whole.state.reset();

  SortedRecords<OrderedFace> in_order(job, share::refine::sorting_vertices(list_memory));
  SpoolCursor<FaceVertices> faces = whole.face_cursor(job);
  RecentBlocks new_numbers(numbers, sizeof(std::uint32_t));
  for (FaceVertices face{}; faces.next(face);) {
    for (std::uint32_t& v : face) v = new_numbers.at<std::uint32_t>(v);
    in_order.add({lowest_first(face)});
  }
  whole.faces.reset();
  MergedCursor<OrderedFace> merged = in_order.merged();
  Appender<OrderedFace> append(job, *out.faces);
  for (OrderedFace face{}; merged.next(face);) append.add(face);
  append.flush();
  out.finish_faces();
  return out;
}

}  // namespace winnow
