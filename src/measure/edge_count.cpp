#include "measure/edge_count.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>

#include <tbb/parallel_sort.h>

namespace winnow {

InfoReport::Edges count_sorted_edges(std::span<const std::uint64_t> edges, const ProgressMeter& progress) {
  InfoReport::Edges counts;
  for (std::size_t at = 0; at < edges.size();) {
    progress.check_cancelled();
    std::size_t next = at;
    while (next < edges.size() && edges[next] == edges[at]) ++next;
    ++counts.total;
    counts.boundary += next - at == 1 ? 1 : 0;
    counts.non_manifold += next - at > 2 ? 1 : 0;
    at = next;
  }
  return counts;
}

EdgeCount::EdgeCount(Job& job, std::uint64_t memory) : job_(job), pages_(job.budget, memory) {}

std::uint64_t EdgeCount::hash_position(const std::array<double, 3>& position) {
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    hash = mixed_hash(hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));  // -0 and 0 are the same place
  }
  return hash;
}

std::uint64_t EdgeCount::hash_edge(std::uint64_t one_end, std::uint64_t other_end) {
  return mixed_hash(std::min(one_end, other_end) + std::rotl(std::max(one_end, other_end), 32));
}

void EdgeCount::add(std::span<const std::uint64_t> edges) {
  const std::scoped_lock lock(mutex_);
  added_ += edges.size();
  if (too_many_) return;
  if (!pages_.grow_to((kept_ + edges.size()) * sizeof(std::uint64_t))) {
    too_many_ = true;
    pages_.give_back();
    return;
  }
  std::memcpy(pages_.data() + kept_ * sizeof(std::uint64_t), edges.data(), edges.size_bytes());
  kept_ += edges.size();
}

std::optional<InfoReport::Edges> EdgeCount::finish() {
  if (too_many_) return {};
  auto* const begin = reinterpret_cast<std::uint64_t*>(pages_.data());
  auto* const end = begin + kept_;
  tbb::parallel_sort(begin, end, job_.progress.cancellable(std::less<>()));
  return count_sorted_edges({begin, end}, job_.progress);
}

}  // namespace winnow
