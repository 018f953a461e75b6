#include "cluster/components.hpp"

#include "base/memory_shares.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

Components::Components(Job& job, std::uint64_t memory)
    : job_(job), memory_(share::components::links(memory)), links_(make()) {}

Components::Links Components::make() const {
  return std::make_unique<SortedRecords<Link>>(job_, memory_);
}

void Components::link(std::uint64_t a, std::uint64_t b) {
  links_->add({a, b});
  links_->add({b, a});
}

template <typename Each>
void Components::for_each(SortedRecords<Link>& links, const Each& each) const {
  MergedCursor<Link> sorted = links.merged();
  Link first{UINT64_MAX, 0};
  std::uint64_t seen = 0;
  for (Link link; sorted.next(link);) {
    if (++seen % chunk_records == 0) job_.progress.check_cancelled();
    if (link.node != first.node) first = link;
    each(first.other, link);
  }
}

// A node links its higher neighbours to the lowest of all its neighbours and itself. Takes links
// both ways, gives each once, from the higher end.
bool Components::large_star(Links& links) const {
  Links out = make();
  bool changed = false;
  for_each(*links, [&](std::uint64_t first, const Link& link) {
    if (link.other < link.node) return;
    changed |= first < link.node;
    out->add({link.other, std::min(first, link.node)});
  });
  links = std::move(out);
  return changed;
}

// A node links its lower neighbours and itself to the lowest of them. Takes links from the higher
// end, gives them both ways.
bool Components::small_star(Links& links) const {
  Links out = make();
  bool changed = false;
  for_each(*links, [&](std::uint64_t first, const Link& link) {
    const bool lowest = link.other == first;
    changed |= !lowest;
    const std::uint64_t node = lowest ? link.node : link.other;
    out->add({node, first});
    out->add({first, node});
  });
  links = std::move(out);
  return changed;
}

void Components::finish(
    const std::function<void(std::uint64_t first, std::uint64_t other)>& member) {
  for (bool changed = true; changed; ++rounds_) {
    changed = large_star(links_);
    changed |= small_star(links_);
  }
  for_each(*links_, [&](std::uint64_t /*first*/, const Link& link) {
    if (link.node < link.other) member(link.node, link.other);
  });
  links_.reset();
}

}  // namespace winnow
