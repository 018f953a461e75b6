// One pass over an input with all threads.
#pragma once

#include "base/per_slot.hpp"
#include "io/job.hpp"
#include "read/mesh_reader.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace winnow {

// Both run inside the job's arena. `sink` is called from several threads at once; the order of
// calls is open. `stop`, asked between batches, ends the pass early; it can be continued by calling
// again.

// Returns false at the end of the input, true where `stop` ended the pass. `wanted`: whether faces
// of a batch are needed at all; without, all are.
bool for_each_face_batch(Job& job, MeshReader& reader, const FaceSink& sink,
                         const std::function<bool()>& stop,
                         const std::function<bool(const RawBatch&)>& wanted = {});

void for_each_position_batch(Job& job, MeshReader& reader, const PositionSink& sink,
                             PassCorners corners = PassCorners::all);

// The same in the input's order: what `encode`, called from several threads, appends for a batch is
// handed to `take` batch after batch, by one thread at a time.
using BatchBytes = std::vector<std::byte>;
using BytesTaker = std::function<void(std::span<const std::byte>)>;
void for_each_face_batch_in_order(Job& job, MeshReader& reader,
                                  const std::function<void(const FaceBatch&, BatchBytes&)>& encode,
                                  const BytesTaker& take);
void for_each_position_batch_in_order(
    Job& job, MeshReader& reader,
    const std::function<void(const PositionView&, BatchBytes&)>& encode, const BytesTaker& take);

// Raw batches under way at one time, for the plan.
constexpr std::size_t batches_in_flight(unsigned threads) {
  return 2 * std::size_t{threads} + 1;
}

}  // namespace winnow
