// A glTF with morph targets as the frames of a mesh that moves: the mesh as it is, then with each
// target alone at its full weight.
#pragma once

#include "base/morph_clip.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

class MorphFrames {
 public:
  virtual ~MorphFrames() = default;
  [[nodiscard]] virtual std::size_t frames() const = 0;
  // How the file plays its targets; nothing where it does not say, or says it of several meshes.
  [[nodiscard]] virtual std::vector<MorphClip> clips() = 0;
  virtual std::unique_ptr<MeshReader> open(std::size_t frame, const ReaderMemory& memory,
                                           const AttributeRequest& wish) = 0;
};

// Null where the file is no glTF. Throws Error(bad_input) where it has no targets, or meshes with
// different numbers of them.
std::unique_ptr<MorphFrames> open_morph_frames(Job& job, const std::string& name, Format from);

}  // namespace winnow
