// Collapses edges, the cheapest first. What an edge costs is the business of a Cost.
//
// A Cost has
//
// - Candidate best(v, after): the cheapest edge that `v` proposes and that comes after `after`;
// - EvaluatedCollapse place(v, partner): which end of that edge is kept, where it goes, what that
//   costs now;
// - void collapsing(now), told that before the collapse; or collapsing(now, star), its star moved
//   there;
// - void collapsed(edge, offers), told after it: makes offers anew for the vertices whose edges now
//   cost otherwise, or makes their offers stale;
// - double cost_of_piece(mesh, piece): what it costs that a piece of the surface goes as a whole,
//   infinite where it may not;
//
// and may have
//
// - double cost_of_change(star, edge, change): what it costs besides that a collapse changes the
//   surface, infinite where it may not; without it no surface changes;
// - double cost_of_turning(star, edge): the same for faces that turn too far; with cost_of_change()
//   only;
// - void faces_gone(faces, offers): told after collapsed() of faces that fell onto each other and
//   went;
// - std::optional<EvaluatedCollapse> other_place(now): the same edge in another way at the same
// cost,
//   asked for where place() gave one that is not legal;
// - bool keeps_faces(legality, star, now): whether no face turns too far, in place of the rule for
//   the mesh alone; may change where `now` goes and what it costs;
// - double closer_cost(now, star, cost): what place() found, looked at more closely, `cost` or
//   more, and infinity where it may not be; asked before every collapse, of one that is legal.
#pragma once

#include "decimate/cost_queue.hpp"
#include "decimate/edge_star.hpp"
#include "decimate/legality.hpp"
#include "decimate/piece.hpp"
#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

// Edges of one vertex are in the order of their costs, and of equal ones in that of the other end.
struct Candidate {
  double cost = std::numeric_limits<double>::infinity();
  VertexNumber partner = no_number;

  [[nodiscard]] bool exists() const { return partner != no_number; }
  [[nodiscard]] bool before(const Candidate& other) const {
    return cost < other.cost || (cost == other.cost && partner < other.partner);
  }
  // Before every other.
  static Candidate none_yet() { return {-std::numeric_limits<double>::infinity(), 0}; }
};

struct EvaluatedCollapse {
  Collapse edge;
  double cost = 0;
};

// The candidate that every vertex offers.
class Offers {
 public:
  explicit Offers(VertexNumber vertices)
      : queue_(vertices),
        partner_(vertices, no_number),
        state_(vertices, settled),
        postponed_(vertices) {}

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return CostQueue::memory(vertices) + vertices * (sizeof(VertexNumber) + 1 + sizeof(Candidate));
  }

  void append(VertexNumber v, const Candidate& candidate) {
    if (!candidate.exists()) return;
    partner_[v] = candidate.partner;
    queue_.append(v, candidate.cost);
  }
  void order() { queue_.order(); }

  // All anew.
  void set(VertexNumber v, const Candidate& candidate) {
    state_[v] = settled;
    replace(v, candidate);
  }

  // An edge that turned out to be costlier gets its turn at its cost, at the latest when no other
  // is left.
  void postpone(VertexNumber v, const Candidate& candidate) {
    if ((state_[v] & waiting) == 0) {
      postponed_[v] = candidate;
    } else {
      state_[v] |= forgot;
      if (candidate.before(postponed_[v])) postponed_[v] = candidate;
    }
    state_[v] |= waiting;
  }

  // What follows after an edge that was refused or postponed. Where nothing does and an edge was
  // forgotten for a cheaper one, which was refused when its turn came, all are looked at again:
  // that one is out now.
  void go_on(VertexNumber v, const Candidate& next) {
    if ((state_[v] & waiting) != 0 && postponed_[v].before(next)) {
      state_[v] &= static_cast<std::uint8_t>(~waiting);
      replace(v, postponed_[v]);
    } else if (!next.exists() && (state_[v] & forgot) != 0) {
      state_[v] = settled;
      make_stale(v);
    } else {
      replace(v, next);
    }
  }

  // The offer is made anew when its turn comes: costs mostly rise, so that it keeps its turn until
  // then. A vertex without an offer gets its turn at once.
  void make_stale(VertexNumber v) {
    state_[v] |= out_of_date;
    if (!queue_.holds(v)) queue_.set(v, 0);
  }
  [[nodiscard]] bool stale(VertexNumber v) const { return (state_[v] & out_of_date) != 0; }

  [[nodiscard]] Candidate of(VertexNumber v) const {
    return queue_.holds(v) ? Candidate{queue_.cost(v), partner_[v]} : Candidate{};
  }

  [[nodiscard]] bool holds(VertexNumber v) const { return queue_.holds(v); }
  [[nodiscard]] bool empty() const { return queue_.empty(); }
  [[nodiscard]] VertexNumber cheapest() const { return queue_.top().vertex; }

 private:
  static constexpr std::uint8_t settled = 0;
  static constexpr std::uint8_t out_of_date = 1;
  static constexpr std::uint8_t waiting = 2;  // with a postponed edge
  static constexpr std::uint8_t forgot = 4;   // another

  void replace(VertexNumber v, const Candidate& candidate) {
    partner_[v] = candidate.partner;
    if (candidate.exists()) {
      queue_.set(v, candidate.cost);
    } else {
      queue_.remove(v);
    }
  }

  CostQueue queue_;
  std::vector<VertexNumber> partner_;
  std::vector<std::uint8_t> state_;
  std::vector<Candidate> postponed_;  // of those that are waiting
};

// What collapses have to respect, besides the topology.
struct CollapseRules {
  double least_cosine = 0;        // of the angle by which one collapse may turn a face
  CoordinateRounding rounding{};  // of positions
  bool keep_pieces = false;       // no piece goes as a whole
  // The topology may change and faces may turn by more, at a cost.
  bool free_topology = false;
};

// How far to go: down to so many faces, or up to this cost, whichever comes first.
struct CollapseLimits {
  std::uint64_t faces = 0;
  double cost = std::numeric_limits<double>::infinity();
  // So far without a queue, which is faster: not quite in the order of costs.
  std::uint64_t sweeps_to = std::numeric_limits<std::uint64_t>::max();
  double sweeps_cost = std::numeric_limits<double>::infinity();
  // With so many faces left sweeps begin to be finer.
  std::uint64_t fine_from = 0;
  bool exact = false;  // no piece goes that would leave fewer faces than one collapse can
};

// One collapse that was done. `cost` is the highest offered so far: it never falls.
struct DoneCollapse {
  Collapse edge;
  double cost = 0;
  unsigned faces = 0;  // that it removed
  double error = 0;    // the largest so far that the cost knows of: Decimation::largest_error()
};

template <typename Cost>
class Collapser {
 public:
  // `highest`: the highest cost of what was collapsed before.
  Collapser(TileMesh& mesh, Cost& cost, const CollapseRules& rules, double highest = 0)
      : mesh_(mesh),
        cost_(cost),
        rules_(rules),
        legality_(mesh, rules.least_cosine),
        star_(rules.rounding),
        highest_(highest) {}

  // Bytes in use at the most, besides the mesh and the cost.
  static constexpr std::uint64_t memory(std::uint64_t vertices) { return Offers::memory(vertices); }

  // Tells `done` of every collapse, while its faces are there where it is a piece that goes. `turn`
  // comes now and then, also where nothing can be collapsed.
  void run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done,
           const std::function<void()>& turn) {
    offers_ = Offers(mesh_.vertex_count());
    for (VertexNumber v = 0; v < mesh_.vertex_count(); ++v)
      offers_.append(v, cost_.best(v, Candidate::none_yet()));
    offers_.order();
    for (std::uint32_t turns = 0; mesh_.live_faces() > limits.faces && !offers_.empty(); ++turns) {
      if (turns % turns_between == 0 && turn) turn();
      const VertexNumber v = offers_.cheapest();
      // What is found beyond a limit lies beyond it, whatever it costs: a piece is offered only
      // when its edges were refused, and an offer made anew may be cheaper than it was.
      const Candidate candidate = offers_.of(v);
      highest_ = std::max(highest_, candidate.cost);
      if (highest_ > limits.cost) return;
      if (offers_.stale(v)) {
        offer_anew(v);
        continue;
      }
      if (candidate.partner == v) {
        take_piece(v, limits, done);
        continue;
      }
      EvaluatedCollapse now = cost_.place(v, candidate.partner);
      if (now.cost > candidate.cost) {
        // The other end has become costlier since.
        offer_anew(v);
        continue;
      }
      const Verdict verdict = judge(now);
      if (!verdict.allowed) {
        // It waits until a collapse beside it makes the vertex offer anew.
        go_on(v, candidate);
        continue;
      }
      double cost = verdict.cost;
      if constexpr (requires { cost_.closer_cost(now, star_, candidate.cost); })
        cost = std::max(cost, closer_cost(now, candidate.cost, verdict.changes));
      if (cost > candidate.cost) {
        if (std::isfinite(cost)) offers_.postpone(v, {cost, candidate.partner});
        go_on(v, candidate);
        continue;
      }
      const Collapse& edge = now.edge;
      if (verdict.changes) add_change(mesh_, star_, change_, changes_);
      unsigned gone = collapse(now);
      offers_.set(edge.removed, {});
      cost_.collapsed(edge, offers_);
      if constexpr (changes_surfaces) {
        if (verdict.changes) gone += remove_pairs(edge.kept);
      }
      done({edge, highest_, gone, cost_.largest_error()});
    }
  }

  // Handles and holes that closed.
  [[nodiscard]] const TopologyChanges& changes() const { return changes_; }

 private:
  static constexpr std::uint32_t turns_between = 1024;
  // The edge of star_. How many faces went.
  unsigned collapse(const EvaluatedCollapse& now) {
    if constexpr (requires { cost_.collapsing(now, star_); }) {
      cost_.collapsing(now, star_);
    } else {
      cost_.collapsing(now);
    }
    return mesh_.collapse(now.edge);
  }

  void offer_anew(VertexNumber v) {
    offers_.set(v, cost_.best(v, Candidate::none_yet()));
    if (!offers_.holds(v)) offer_piece(v);
  }
  void go_on(VertexNumber v, const Candidate& candidate) {
    offers_.go_on(v, cost_.best(v, candidate));
    if (!offers_.holds(v)) offer_piece(v);
  }

  // A piece is offered as a whole, by its lowest vertex to itself, as soon as none of its edges is
  // offered.
  void offer_piece(VertexNumber v) {
    const auto is_offered = [this](VertexNumber w) { return offers_.holds(w); };
    // Nearly always some edge beside it is.
    if (rules_.keep_pieces || mesh_.has_neighbour(v, is_offered)) return;
    if (!piece_.find(mesh_, v, is_offered)) return;
    const double cost = cost_.cost_of_piece(mesh_, piece_);
    if (!std::isfinite(cost)) return;
    const VertexNumber lowest = *std::min_element(piece_.vertices.begin(), piece_.vertices.end());
    offers_.set(lowest, {cost, lowest});
  }

  // The last piece stays.
  void take_piece(VertexNumber v, const CollapseLimits& limits,
                  const std::function<void(const DoneCollapse&)>& done) {
    piece_.find(mesh_, v);
    offers_.set(v, {});
    if (piece_.faces.size() >= mesh_.live_faces()) return;
    if (limits.exact && mesh_.live_faces() - piece_.faces.size() + 1 < limits.faces) return;
    const auto faces = static_cast<unsigned>(piece_.faces.size());
    done({{v, v, mesh_.position(v)}, highest_, faces, cost_.largest_error()});
    mesh_.remove(piece_.vertices, piece_.faces);
  }

  static constexpr bool changes_surfaces =
      requires(Cost cost, const EdgeStar& star, const Collapse& edge, const SurfaceChange& change) {
    cost.cost_of_change(star, edge, change);
  };

  // `cost`: no less, for what it changes.
  struct Verdict {
    bool allowed = false;
    bool changes = false;  // the surface: change_
    double cost = 0;
  };

  // Whether the collapse is legal; in the other way that the cost knows, if not in this.
  Verdict judge(EvaluatedCollapse& now) {
    star_.find(mesh_, now.edge.kept, now.edge.removed);
    Verdict verdict;
    if (!legality_.keeps_surface(star_)) {
      if constexpr (changes_surfaces) {
        if (!rules_.free_topology || !legality_.find_change(star_, change_)) return {};
        verdict = {true, true, now.cost + cost_.cost_of_change(star_, now.edge, change_)};
        if (!std::isfinite(verdict.cost)) return {};
      } else {
        return {};
      }
    }
    verdict.allowed = true;
    if constexpr (requires { cost_.keeps_faces(legality_, star_, now); }) {
      verdict.allowed = cost_.keeps_faces(legality_, star_, now);
      verdict.cost = now.cost;
      return verdict;
    }
    if (legality_.keeps_faces(star_, now.edge)) return verdict;
    if constexpr (requires { cost_.other_place(now); }) {
      if (const auto other = cost_.other_place(now)) {
        const EvaluatedCollapse first = std::exchange(now, *other);
        if (legality_.keeps_faces(star_, now.edge)) return verdict;
        now = first;
        if (rules_.free_topology) star_.move(mesh_, now.edge.position, rules_.least_cosine);
      }
    }
    if constexpr (changes_surfaces) {
      if (rules_.free_topology) {
        verdict.cost = std::max(verdict.cost, now.cost) + cost_.cost_of_turning(star_, now.edge);
        verdict.allowed = std::isfinite(verdict.cost);
        return verdict;
      }
    }
    return {};
  }

  double closer_cost(const EvaluatedCollapse& now, double cost, [[maybe_unused]] bool changes) {
    if constexpr (changes_surfaces) {
      return cost_.closer_cost(now, star_, cost, changes ? &change_ : nullptr);
    } else {
      return cost_.closer_cost(now, star_, cost);
    }
  }

  unsigned remove_pairs(VertexNumber v) {
    gone_.clear();
    const unsigned gone = mesh_.remove_pairs(v, gone_);
    if (gone > 0) cost_.faces_gone(gone_, offers_);
    return gone;
  }

  TileMesh& mesh_;
  Cost& cost_;
  CollapseRules rules_;
  Legality legality_;
  EdgeStar star_;
  Offers offers_{0};
  Piece piece_;
  SurfaceChange change_;
  std::vector<FaceVertices> gone_;
  TopologyChanges changes_;
  double highest_;  // cost of an offer so far
};

}  // namespace winnow
