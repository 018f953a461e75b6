#include "generate/surface.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

namespace winnow {

namespace {

constexpr std::uint64_t fewest_faces = 8;  // the octahedron
constexpr std::uint64_t most_generated = std::uint64_t{1}
                                         << 48;  // 14 PB of STL; rows stay countable in 32 bits

}  // namespace

Point GeneratedSurface::vertex(std::uint64_t id) const {
  Point point{};
  positions({&id, 1}, {&point, 1});
  return point;
}

MeshFace GeneratedSurface::face(std::uint64_t id) const {
  MeshFace face;
  corners({&id, 1}, {&face, 1});
  return face;
}

std::unique_ptr<GeneratedSurface> make_surface(const GenerateOptions& options) {
  if (options.faces < fewest_faces || options.faces > most_generated) {
    throw Error(ErrorKind::usage, "cannot generate " + grouped(options.faces) + " faces; ask for " +
                                      grouped(fewest_faces) + " to " + grouped(most_generated));
  }
  switch (options.surface) {
    case Surface::scan:
      return make_scan(options);
    case Surface::terrain:
      return make_terrain(options);
    case Surface::part:
      return make_part(options);
  }
  throw Error(ErrorKind::usage, "there is no such surface");
}

}  // namespace winnow
