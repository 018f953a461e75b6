// Simplify a mesh that the program itself makes, batch by batch, without a file in between.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/mesh.hpp>
#include <winnow/simplify.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// Takes a mesh of any size in batches of any size, in bounded memory, and simplifies it when all is
// there:
//
//   winnow::Simplification simplification(context, "small.ply", options);
//   while (...) {
//     simplification.add_vertices(positions);  // x y z x y z ...
//     simplification.add_faces(corners);       // three numbers of vertices each
//   }
//   simplification.finish();
//
// What is added is kept in memory while half of the budget lasts and then in scratch, as finding
// the cell or the cost for a face count takes several passes: 12 bytes a vertex (24 in double) and
// 13 a face, or 50 a triangle without vertices of its own (85 in double).
//
// A thin layer over MeshSource (stream.hpp), for programs that cannot be called for the next batch.
//
// The output has the same bytes as simplify() gives for a PLY of these vertices and faces, of
// floats or doubles as they were added; of triangles without vertices, for a binary STL of them,
// or, in double, for a PLY in which each has three vertices of its own. The size of the batches
// does not matter.
//
// To be used by one thread at a time, except for Context::cancel(). After an Error it can only be
// destroyed; destroyed before finish() was called, it leaves nothing behind. The context must
// outlive it; its memory, threads and scratch are looked at here and not later.
class WINNOW_API Simplification {
 public:
  // Throws Error: usage (options, an output that exists), resources (too small a budget).
  Simplification(Context& context, const std::string& output, const SimplifyOptions& options);
  // For finish_mesh(): the result stays in memory.
  Simplification(Context& context, const SimplifyOptions& options);
  ~Simplification();
  Simplification(const Simplification&) = delete;
  Simplification& operator=(const Simplification&) = delete;

  // Vertices, with what they carry, faces, or both. The vertices of all batches carry the same
  // attributes.
  void add(const MeshView& batch);
  // Loose triangles: each three positions are one.
  void add_triangles(const MeshView& batch);

  // Three coordinates for each vertex. Vertices are numbered from 0 in the order in which they
  // come. All positions are floats or all are doubles. At most 2^32 - 1 vertices.
  void add_vertices(std::span<const float> coordinates);
  void add_vertices(std::span<const double> coordinates);

  // Three numbers of vertices for each face; the vertices may come later. A number that no vertex
  // has got when all is there makes the face a bad one: counted and left out.
  void add_faces(std::span<const std::uint32_t> corners);

  // Instead of both: nine coordinates for each triangle, corner by corner.
  void add_triangles(std::span<const float> coordinates);
  void add_triangles(std::span<const double> coordinates);

  // All of these throw Error: usage (a span that ends inside a vertex or face, floats and doubles
  // or both kinds of mesh in one, more vertices than are counted), resources (disk full),
  // cancelled.

  // Simplifies and writes; the last call. options.from has no meaning here. Throws what simplify()
  // throws.
  SimplifyReport finish();
  // The same where no output was named: gives the mesh, which does not count in the budget, and
  // puts the report where `report` points, if anywhere.
  Mesh finish_mesh(SimplifyReport* report = nullptr);
  // The same for several targets, the finest first.
  std::vector<Mesh> finish_meshes(SimplifyReport* report = nullptr);

 private:
  struct WINNOW_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace winnow
