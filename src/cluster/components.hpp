// Connected components of a graph of any size, in bounded memory.
#pragma once

#include "io/job.hpp"
#include "io/sorted_records.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace winnow {

// Links are replaced by others until each component is a star around its lowest number, in rounds
// of two sorts: the large star and the small star of Kiveris et al., "Connected components in
// MapReduce and beyond" (2014). Links never become more. The rounds grow with the logarithm of the
// longest chain.
class Components {
 public:
  // Sorts within `memory`.
  Components(Job& job, std::uint64_t memory);

  void link(std::uint64_t a, std::uint64_t b);  // two different numbers

  // member(first, other) for each number that is not the lowest of its component, which `first` is;
  // ascending by both. The last call.
  void finish(const std::function<void(std::uint64_t first, std::uint64_t other)>& member);

  [[nodiscard]] std::uint64_t rounds() const { return rounds_; }

 private:
  struct Link {
    std::uint64_t node, other;

    static bool before(const Link& a, const Link& b) {
      return a.node != b.node ? a.node < b.node : a.other < b.other;
    }
    static bool combine(Link& /*into*/, const Link& /*from*/) { return true; }
  };
  using Links = std::unique_ptr<SortedRecords<Link>>;

  // Calls node(first, link) for each link, by nodes; `first` is the lowest other of the node.
  template <typename Each>
  void for_each(SortedRecords<Link>& links, const Each& each) const;
  [[nodiscard]] Links make() const;
  [[nodiscard]] bool large_star(Links& links) const;
  [[nodiscard]] bool small_star(Links& links) const;

  Job& job_;
  std::uint64_t memory_;
  Links links_;  // both ways
  std::uint64_t rounds_ = 0;
};

}  // namespace winnow
