// Simplify from wherever a mesh comes to wherever the result goes: files, arrays, batches.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/mesh.hpp>
#include <winnow/simplify.hpp>

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace winnow {

// Gives a mesh in batches of any size. `batch` comes empty and gets vertices, faces, or both; its
// arrays have to stay until the next call. Returns false, and gives nothing, when all is there.
//
// Faces name vertices by their numbers over all batches, from 0; the vertices may come later. All
// positions are of one type, and the vertices of all batches carry the same attributes. Called by
// the thread that called simplify(); what it throws ends that call.
using BatchSource = std::function<bool(MeshView& batch)>;

// Takes a mesh in batches: first those of vertices with what they carry, then those of faces, which
// name vertices by their numbers over all batches. A batch is good until the call ends. Never
// called from two threads at once; what it throws ends simplify(). Where simplify() throws, what
// was taken before is no mesh.
using BatchSink = std::function<void(const MeshView& batch)>;

// What a mesh comes from.
class MeshSource {
 public:
  // Batches of loose triangles: each three positions are one, and there are no faces.
  struct Triangles {
    BatchSource batches;
  };
  using Kind = std::variant<std::vector<std::string>, MeshView, BatchSource, Triangles>;

  // A file's name, or "-" for standard input.
  MeshSource(std::string file) : kind_(std::vector{std::move(file)}) {}
  // Several files as one model, in their order.
  MeshSource(std::vector<std::string> files) : kind_(std::move(files)) {}
  // Arrays, which have to stay as they are.
  MeshSource(MeshView mesh) : kind_(std::move(mesh)) {}
  MeshSource(const Mesh& mesh) : kind_(mesh.view()) {}
  // What batches give is kept in memory while half of the budget lasts and then in scratch.
  MeshSource(BatchSource batches) : kind_(std::move(batches)) {}
  MeshSource(Triangles triangles) : kind_(std::move(triangles)) {}

  [[nodiscard]] const Kind& kind() const { return kind_; }

 private:
  Kind kind_;
};

// Where a mesh goes.
class MeshSink {
 public:
  using Kind = std::variant<std::string, Mesh*, std::vector<Mesh>*, BatchSink>;

  // A file's name, or "-" for standard output; several targets give several files, as simplify()
  // of files tells.
  MeshSink(std::string file) : kind_(std::move(file)) {}
  // It has to stay until simplify() ends.
  MeshSink(Mesh& mesh) : kind_(&mesh) {}
  // One for each target (SimplifyOptions::coarser), the finest first. The others take one mesh.
  MeshSink(std::vector<Mesh>& meshes) : kind_(&meshes) {}
  MeshSink(BatchSink batches) : kind_(std::move(batches)) {}

  [[nodiscard]] const Kind& kind() const { return kind_; }

 private:
  Kind kind_;
};

// All other simplify() are this one, from one kind of source to one kind of sink. The result is
// that of the file with the same content: a PLY, or, of loose triangles of floats that carry
// nothing, a binary STL. `map`: where the VertexMap goes, if anywhere; of one target.
//
// Throws Error as those do, also where batches do not fit together; the message names the array.
WINNOW_API SimplifyReport simplify(Context& context, const MeshSource& source, const MeshSink& sink,
                                   const SimplifyOptions& options, VertexMap* map = nullptr);
// With a map for each target, the finest first.
WINNOW_API SimplifyReport simplify(Context& context, const MeshSource& source, const MeshSink& sink,
                                   const SimplifyOptions& options, std::vector<VertexMap>& maps);

}  // namespace winnow
