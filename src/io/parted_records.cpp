#include "io/parted_records.hpp"

#include "base/memory_shares.hpp"

namespace winnow {

PartsPlan PartsPlan::divide(std::uint64_t memory, unsigned threads, std::uint64_t records,
                            std::size_t record_bytes, std::size_t bytes_at_work) {
  // What is sorted at once stays in a core's second cache, and takes little beside the lists.
  constexpr std::uint64_t usual_records = std::uint64_t{1} << 14;
  constexpr std::uint64_t most_parts = std::uint64_t{1} << 12;
  constexpr std::uint64_t smallest_chunk = std::uint64_t{1} << 12;
  constexpr std::uint64_t largest_chunk = std::uint64_t{1} << 15;
  PartsPlan plan{};
  const std::uint64_t chunks = share::parted::first_chunks(memory);
  const std::uint64_t lists = std::max<std::uint64_t>(chunks / smallest_chunk / threads, 1);
  plan.parts = std::min({records / usual_records + 1, most_parts, lists});
  const std::uint64_t even = records / plan.parts + 1;
  plan.chunk_bytes =
      std::clamp(std::bit_floor(std::min(chunks / threads / plan.parts, even * record_bytes)),
                 smallest_chunk, largest_chunk);
  // Parts may be twice as large as they should be.
  plan.sorting = std::min(share::parted::sorting(memory),
                          at_work(threads) * 2 * std::max(even, usual_records) * bytes_at_work);
  plan.largest_records =
      std::max<std::uint64_t>(plan.sorting * 3 / 4 / at_work(threads) / bytes_at_work, 1);
  // Whole steps of growing pages.
  constexpr std::uint64_t step = std::uint64_t{1} << 16;
  const std::uint64_t first_chunks = threads * plan.parts * plan.chunk_bytes;
  plan.chunks = (std::max(memory - plan.sorting, first_chunks) + step - 1) / step * step;
  return plan;
}

}  // namespace winnow
