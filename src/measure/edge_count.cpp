#include "measure/edge_count.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <tbb/parallel_sort.h>

namespace winnow {

namespace {

// Of the memory, what reading all that was spilled takes.
std::uint64_t beside_merging(std::uint64_t memory, std::uint64_t merging) {
  return std::max(memory - std::min(memory, merging), share::count::least_beside_merging(memory));
}

}  // namespace

EdgeCount::EdgeCount(Job& job, std::uint64_t memory)
    : job_(job),
      pages_(job.budget, beside_merging(memory, SortedRuns<Edge>::merge_memory())),
      runs_(job) {}

void EdgeCount::add(std::span<const std::uint64_t> edges) {
  const std::scoped_lock lock(mutex_);
  if (!pages_.grow_to((kept_ + edges.size()) * sizeof(Edge))) {
    spill();
    if (!pages_.grow_to(edges.size() * sizeof(Edge)))
      throw Error(ErrorKind::resources,
                  "there is no memory left to count edges in; raise `memory`");
  }
  std::memcpy(pages_.data() + kept_ * sizeof(Edge), edges.data(), edges.size_bytes());
  kept_ += edges.size();
}

void EdgeCount::spill() {
  if (kept_ == 0) return;
  // By this thread alone: it holds the lock that other work of it would wait for.
  std::sort(kept().begin(), kept().end(), job_.progress.cancellable(Before<Edge>()));
  MemoryCursor<Edge> all(kept());
  runs_.add(all);
  kept_ = 0;
}

SurfaceEdges EdgeCount::finish() {
  tbb::parallel_sort(kept().begin(), kept().end(), job_.progress.cancellable(Before<Edge>()));
  EdgeRuns counts;
  const auto count = [&](RecordCursor<Edge>& edges) {
    std::uint64_t seen = 0;
    for (Edge edge{}; edges.next(edge);) {
      if (++seen % 4096 == 0) job_.progress.check_cancelled();
      counts.add(edge.hash);
    }
  };
  std::vector<std::unique_ptr<RecordCursor<Edge>>> sources;
  sources.push_back(std::make_unique<MemoryCursor<Edge>>(kept()));
  if (runs_.empty()) {
    count(*sources.front());
  } else {
    runs_.add_cursors(sources);
    MergedCursor<Edge> merged(std::move(sources));
    count(merged);
  }
  pages_.give_back();
  return counts.finish();
}

}  // namespace winnow
