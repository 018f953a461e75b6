// Edges by how many faces meet in them.
#pragma once

#include <winnow/simplify.hpp>

#include "base/growing_pages.hpp"
#include "io/job.hpp"
#include "io/sorted_runs.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>

namespace winnow {

// Counts edges that come once for each face, equal ones one after the other.
class EdgeRuns {
 public:
  void add(std::uint64_t edge) {
    if (run_ > 0 && edge != edge_) end();
    edge_ = edge;
    ++run_;
  }

  SurfaceEdges finish() {
    if (run_ > 0) end();
    return counts_;
  }

 private:
  void end() {
    ++counts_.total;
    counts_.boundary += run_ == 1 ? 1 : 0;
    counts_.non_manifold += run_ > 2 ? 1 : 0;
    run_ = 0;
  }

  SurfaceEdges counts_;
  std::uint64_t edge_ = 0, run_ = 0;
};

// Keeps a 64-bit hash of every side of every face, in memory or scratch, and sorts them at the end.
// Two of n different edges are taken for one with a chance of n^2 / 2^65: for 10^8 edges, one in
// 3700.
class EdgeCount {
 public:
  EdgeCount(Job& job, std::uint64_t memory);

  void add(std::span<const std::uint64_t> edges);  // from any thread

  SurfaceEdges finish();

 private:
  struct Edge {
    std::uint64_t hash;

    static bool before(const Edge& a, const Edge& b) { return a.hash < b.hash; }
    static bool combine(Edge& /*into*/, const Edge& /*from*/) { return false; }
  };

  [[nodiscard]] std::span<Edge> kept() const {
    return {reinterpret_cast<Edge*>(pages_.data()), kept_};
  }
  void spill();

  Job& job_;
  GrowingPages pages_;
  SortedRuns<Edge> runs_;
  std::mutex mutex_;
  std::uint64_t kept_ = 0;  // of them in memory
};

}  // namespace winnow
