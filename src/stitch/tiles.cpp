#include "stitch/tiles.hpp"

namespace winnow {

namespace {

// One face in so many may have corners in several tiles; with more, tiles are larger, up to so many
// times.
constexpr std::uint64_t most_seams = 4;
constexpr std::uint64_t largest_tiles = 64;

}  // namespace

Tiles::Tiles(Job& job, const StoredMesh& whole, const RefineSettings& settings,
             const RefineMemory& memory)
    : job_(job), whole_(whole), settings_(settings), memory_(memory), cut_(cut()) {}

// Where most faces are longer than tiles, as those of a tube without rings, nothing could go: such
// a mesh gets larger tiles.
Tiles::Cut Tiles::cut() const {
  const StoredMesh& mesh = whole_;
  for (std::uint64_t tile_faces = settings_.tile_faces;; tile_faces *= 8) {
    Tiling tiling(mesh, tile_faces);
    IncomingFaces incoming(job_, mesh, tiling, memory_.lists, settings_.hub_faces);
    const bool few = incoming.seam_faces() <= mesh.face_count / most_seams;
    if (few || tiling.tiles() == 1 || tile_faces >= largest_tiles * settings_.tile_faces)
      return {std::move(tiling), std::move(incoming)};
  }
}

Tiles::AtOnce Tiles::reserve() const {
  const auto largest_of = [this](const auto& memory_of) {
    return largest_tile(cut_.tiling, cut_.incoming, memory_of);
  };
  const std::uint64_t largest = largest_of([this](std::uint64_t vertices, std::uint64_t faces) {
    return tile_memory(settings_, vertices, faces);
  });
  const std::uint64_t result = largest_of([this](std::uint64_t vertices, std::uint64_t faces) {
    return result_memory(settings_, std::max(2 * vertices, faces)) + faces * sizeof(FaceVertices);
  });
  AtOnce at_once;
  at_once.tiles = std::clamp<std::uint64_t>(memory_.tiles / largest, 1, job_.threads);
  at_once.working = job_.budget.reserve(at_once.tiles * largest, "refining a tile");
  // Where not all threads are at work, each that waits would be one more.
  if (at_once.tiles < job_.threads || at_once.tiles == 1) return at_once;
  const std::uint64_t room = (memory_.tiles - at_once.tiles * largest) / result;
  const std::uint64_t waiting = std::min<std::uint64_t>(room, (job_.threads + 1) / 2);
  at_once.waiting = job_.budget.try_reserve(waiting * result);
  if (at_once.waiting) at_once.tiles += waiting;
  return at_once;
}

}  // namespace winnow
