// One tile made smaller, at one of the costs: knows no files, no threads and no other tile.
#pragma once

#include <winnow/costs.hpp>

#include "decimate/collapser.hpp"
#include "decimate/tile_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace winnow {

// A mesh that moves: one connectivity, and positions of each vertex in every frame.
struct SequenceSettings {
  std::size_t frames = 1;
  double deformation_weight = 0;  // of how much costs differ between frames
  double feature_weight = 0;      // of what kind of edge it is in the first and the last frame
  bool accumulated = false;       // quadrics remember: accumulated_frames.cpp
  bool operator==(const SequenceSettings&) const = default;
};

struct DecimationSettings {
  Refine cost = Refine::quadric;  // not none
  bool single = true;             // vertices go to numbers that floats have
  double least_cosine = 0.2;      // of the angle by which one collapse may turn a face
  bool keep_boundaries = false;   // vertices at boundaries stay
  bool keep_pieces = false;       // no piece of the surface goes as a whole
  bool free_topology = false;     // handles and holes may close
  bool boundaries_known =
      false;  // by the state; it is that of cells otherwise, whose planes are those of faces alone
  std::optional<double> error;  // how far the surface may come from what it was: error_bound.hpp
  std::optional<SequenceSettings> sequence;  // the state of vertices: frames.hpp

  std::optional<CoordinateRounding> rounding;  // of positions; absent: that of their type

  [[nodiscard]] CoordinateRounding rounding_of_positions() const {
    return rounding.value_or(coordinate_rounding(single));
  }
  bool operator==(const DecimationSettings&) const = default;
};

class Decimation {
 public:
  // `state`: what save() gave for each vertex, or nothing for a mesh in which nothing has been
  // collapsed.
  static std::unique_ptr<Decimation> make(TileMesh& mesh, std::span<const std::byte> state,
                                          const DecimationSettings& settings);
  // Repeats collapses that any cost has chosen, and watches the error that they need
  // (error_bound.hpp). `state`: what save() gave, of watched_state_size() bytes, or nothing.
  static std::unique_ptr<Decimation> make_watching(TileMesh& mesh, std::span<const std::byte> state,
                                                   const DecimationSettings& settings);
  virtual ~Decimation() = default;

  // Bytes that a vertex takes to remember what was collapsed into it; 0 where nothing is
  // remembered.
  static std::size_t state_size(const DecimationSettings& settings);
  // The same of what comes from clustering.
  static std::size_t first_state_size(const DecimationSettings& settings);
  static std::size_t watched_state_size();
  // Bytes in use at the most, besides the mesh.
  static std::uint64_t memory(const DecimationSettings& settings, std::uint64_t vertices);

  // Collapses edges, the cheapest first; `done` is told of each. `turn` comes many times a second,
  // also where nothing can be collapsed; what it throws ends the run.
  virtual void run(const CollapseLimits& limits,
                   const std::function<void(const DoneCollapse&)>& done,
                   const std::function<void()>& turn) = 0;
  void run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done) {
    run(limits, done, {});
  }

  // Repeats collapses of an earlier run of the same settings.
  virtual void repeat(std::span<const Collapse> edges) = 0;
  void repeat(const Collapse& edge) { repeat(std::span(&edge, 1)); }

  // Of make_watching(): the least error within which what was repeated last would have been
  // allowed, but for points that are remembered.
  [[nodiscard]] virtual double needed_error() const { return 0; }

  // Writes state_size() bytes.
  virtual void save(VertexNumber v, std::byte* into) const = 0;

  // The largest distance of a vertex from its planes so far, in the mean; 0 where the cost knows
  // none.
  [[nodiscard]] virtual double largest_error() const = 0;

  // What went besides, by all collapses that were made or repeated.
  [[nodiscard]] const TopologyChanges& changes() const { return changes_; }

 protected:
  void add(const TopologyChanges& changes) { changes_.add(changes); }
  // Whether the collapse of this edge changes the surface, and how; counts it.
  bool find_change(TileMesh& mesh, const EdgeStar& star, SurfaceChange& change);
  // Repeats the going of a piece, and returns it.
  const Piece& repeat_piece(TileMesh& mesh, VertexNumber v);
  // For what run() tells: counts the pieces that go.
  std::function<void(const DoneCollapse&)> counting(
      TileMesh& mesh, const std::function<void(const DoneCollapse&)>& done);

 private:
  TopologyChanges changes_;
  Piece piece_;
};

}  // namespace winnow
