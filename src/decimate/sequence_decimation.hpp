// One tile of a sequence made smaller: all of its frames at once.
#pragma once

#include "decimate/decimation.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace winnow {

// `state`: of each vertex Decimation::first_state_size() bytes, or what save() wrote where
// settings.boundaries_known. The mesh is linked.
std::unique_ptr<Decimation> make_sequence_decimation(TileMesh& mesh,
                                                     std::span<const std::byte> state,
                                                     const DecimationSettings& settings);

// Bytes in use at the most, besides the mesh and the state.
std::uint64_t sequence_decimation_memory(const SequenceSettings& settings, std::uint64_t vertices);

}  // namespace winnow
