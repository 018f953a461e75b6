// What refinement is asked for, and the memory that it gets.
#pragma once

#include "base/attribute.hpp"
#include "decimate/decimation.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

struct RefineSettings {
  DecimationSettings decimation;
  std::uint64_t faces = 0;  // wanted; 0: as few as there can be
  std::uint64_t tile_faces = std::uint64_t{1}
                             << 16;  // changes the result a little: never derived from memory
  std::uint64_t hub_faces = 512;  // a vertex with more faces across tiles is a hub: as tile_faces
  std::vector<Attribute> attributes{};  // that vertices carry
  bool map = false;                     // whether the result tells where vertices went
  bool unfolds_thoroughly = false;      // UnfoldRules::thorough
  std::size_t record_bytes = 0;         // that writing a collapse down takes; 0: none is

  // Whoever asks for an error gets the surface on which it was watched. The frames of a sequence
  // are unfolded one by one.
  [[nodiscard]] bool unfolds() const { return !decimation.error && !decimation.sequence; }
  // An error is watched in the order of costs.
  [[nodiscard]] bool in_sweeps() const { return !decimation.error; }
  // With so many times the wanted faces left sweeps begin to be finer.
  static constexpr double fine_beside_wanted = 2;

  // Whether what collapses take away is written down. Then the error is watched that they need.
  [[nodiscard]] bool records() const { return record_bytes > 0; }

  // Bytes a vertex that rounds leave, and that a round begins with.
  [[nodiscard]] std::size_t state_size() const {
    return records() ? Decimation::watched_state_size() : Decimation::state_size(decimation);
  }
  [[nodiscard]] std::size_t known_state_size() const {
    return decimation.boundaries_known || records() ? state_size()
                                                    : Decimation::first_state_size(decimation);
  }
  // That a round chooses collapses by.
  [[nodiscard]] std::size_t choosing_state_size() const {
    return records() ? 0 : known_state_size();
  }
};

struct RefineMemory {
  std::uint64_t tiles = 0;  // being worked on, all threads together
  std::uint64_t logs = 0;
  std::uint64_t mesh = 0;   // what comes out of a round
  std::uint64_t lists = 0;  // sorting
};

// What a tile of so many vertices and faces takes while it is worked on.
std::uint64_t tile_memory(const RefineSettings& settings, std::uint64_t vertices,
                          std::uint64_t faces);

// What is left of a tile that was collapsed: a log, or what is left of the mesh.
std::uint64_t result_memory(const RefineSettings& settings, std::uint64_t faces);

}  // namespace winnow
