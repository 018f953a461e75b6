// The parts of the library that may be left out when it is built.
#pragma once

#include <winnow/api.hpp>
#include <winnow/error.hpp>

#include <string>

namespace winnow {

enum class Part {
  gltf,    // reading and writing glTF (needs nlohmann/json, meshoptimizer)
  compare  // compare() and its pictures (needs Embree, Cairo)
};

// Whether this library was built with it.
WINNOW_API bool has_part(Part part);

// Thrown by a call that needs a part that this library was built without. Its kind is failed.
class WINNOW_API MissingPart : public Error {
 public:
  // `failed`: what cannot be done, "'scan.glb' cannot be read".
  MissingPart(Part part, const std::string& failed);

  [[nodiscard]] Part part() const noexcept { return part_; }

 private:
  Part part_;
};

}  // namespace winnow
