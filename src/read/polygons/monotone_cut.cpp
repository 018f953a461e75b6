#include "read/polygons/monotone_cut.hpp"

#include "base/sort_unique.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>

namespace winnow {

namespace {

using Corner = std::uint32_t;

constexpr Corner no_corner = UINT32_MAX;

class MonotoneCut {
 public:
  MonotoneCut(std::span<const PlanePoint> corners, Pace& pace,
              std::vector<std::array<std::uint32_t, 3>>& triangles)
      : at_(corners),
        count_(static_cast<Corner>(corners.size())),
        pace_(pace),
        triangles_(triangles),
        below_(Below{this}) {}

  void run() {
    order_.resize(count_);
    std::iota(order_.begin(), order_.end(), Corner{0});
    std::sort(order_.begin(), order_.end(), [&](Corner a, Corner b) {
      pace_();
      return at_[a] != at_[b] ? at_[a] < at_[b] : a < b;
    });
    rank_.resize(count_);
    for (Corner i = 0; i < count_; ++i) {
      pace_();
      rank_[order_[i]] = i;
    }
    // Each takes a while to be filled.
    helper_.assign(count_, no_corner);
    pace_.ask();
    is_merge_.assign(count_, false);
    place_.assign(count_, below_.end());
    pace_.ask();
    for (const Corner v : order_) {
      if (!sweep_over(v)) return;
    }
    cut_along_diagonals();
  }

 private:
  [[nodiscard]] Corner next(Corner v) const { return v + 1 == count_ ? 0 : v + 1; }
  [[nodiscard]] Corner before(Corner v) const { return v == 0 ? count_ - 1 : v - 1; }
  [[nodiscard]] bool left_of(Corner a, Corner b) const { return rank_[a] < rank_[b]; }

  // Above 0 where c lies to the left of the way from a to b.
  [[nodiscard]] double turn(Corner a, Corner b, Corner c) const {
    return (at_[b][0] - at_[a][0]) * (at_[c][1] - at_[a][1]) -
           (at_[b][1] - at_[a][1]) * (at_[c][0] - at_[a][0]);
  }

  // Edges that lead to the right, by the corner they begin at, have the inside above them. The
  // order of those that one vertical line meets, from below.
  struct Below {
    using is_transparent = void;
    const MonotoneCut* cut;

    bool operator()(Corner a, Corner b) const {
      if (a == b) return false;
      if (cut->left_of(a, b)) {
        const double side = cut->turn(a, cut->next(a), b);
        return side != 0 ? side > 0 : cut->turn(a, cut->next(a), cut->next(b)) > 0;
      }
      const double side = cut->turn(b, cut->next(b), a);
      return side != 0 ? side < 0 : cut->turn(b, cut->next(b), cut->next(a)) < 0;
    }
    struct Point {
      Corner corner;
    };
    bool operator()(Corner edge, Point point) const {
      return cut->turn(edge, cut->next(edge), point.corner) > 0;
    }
    bool operator()(Point point, Corner edge) const {
      return cut->turn(edge, cut->next(edge), point.corner) < 0;
    }
  };
  using Edges = std::set<Corner, Below>;

  bool begin_edge(Corner v) {
    const auto [place, is_new] = below_.insert(v);
    if (!is_new) return false;
    place_[v] = place;
    helper_[v] = v;
    return true;
  }

  // `v` meets the edge: a diagonal, if a merge waits there.
  void meet(Corner edge, Corner v) {
    if (is_merge_[helper_[edge]]) diagonals_.push_back({v, helper_[edge]});
    helper_[edge] = v;
  }

  bool end_edge(Corner edge, Corner v) {
    if (place_[edge] == below_.end()) return false;
    meet(edge, v);
    below_.erase(place_[edge]);
    place_[edge] = below_.end();
    return true;
  }

  [[nodiscard]] Corner edge_under(Corner v) const {
    auto at = below_.lower_bound(typename Below::Point{v});
    return at == below_.begin() ? no_corner : *std::prev(at);
  }

  // False where the polygon cannot be simple.
  bool sweep_over(Corner v) {
    pace_();
    const Corner p = before(v);
    const Corner q = next(v);
    const bool from_left = left_of(p, v);
    const bool to_left = left_of(q, v);
    const bool convex = turn(p, v, q) > 0;
    if (from_left && !end_edge(p, v)) return false;
    if (from_left == to_left ? !convex : to_left) {
      const Corner edge = edge_under(v);
      if (edge == no_corner) return false;
      if (from_left || to_left) {
        meet(edge, v);
      } else {
        diagonals_.push_back({v, helper_[edge]});
        helper_[edge] = v;
      }
    }
    is_merge_[v] = from_left && to_left && !convex;
    return to_left || begin_edge(v);
  }

  // Sides of the parts: the polygon's own, from each corner to the next, and diagonals both ways.
  void cut_along_diagonals() {
    sort_unique(diagonals_, [&](const auto& a, const auto& b) {
      pace_();
      return a < b;
    });
    std::vector<std::uint32_t> first(count_ + std::size_t{1}, 0);
    for (const auto& [a, b] : diagonals_) {
      pace_();
      ++first[a + 1];
      ++first[b + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Corner> to(2 * diagonals_.size());
    std::vector<std::uint32_t> filled(first.begin(), first.end() - 1);
    for (const auto& [a, b] : diagonals_) {
      pace_();
      to[filled[a]++] = b;
      to[filled[b]++] = a;
    }
    for (Corner v = 0; v < count_; ++v) {
      pace_();
      sort_around(v, std::span(to).subspan(first[v], first[v + 1] - first[v]));
    }
    std::vector<bool> walked(count_ + to.size(), false);  // own sides, then diagonals
    std::vector<Corner> part;
    for (std::size_t begin = 0; begin < walked.size(); ++begin) {
      if (walked[begin]) continue;
      part.clear();
      Corner from = begin < count_ ? static_cast<Corner>(begin) : from_of(first, begin - count_);
      for (std::size_t side = begin; !walked[side];) {
        pace_();
        walked[side] = true;
        part.push_back(from);
        const Corner end = side < count_ ? next(from) : to[side - count_];
        // Of the sides around its end the one before the way back: behind an own side the last.
        std::size_t back = first[end + 1];
        if (side >= count_) {
          back = first[end];
          for (; back < first[end + 1] && to[back] != from; ++back) pace_();
        }
        side = back == first[end] ? end : count_ + back - 1;
        from = end;
      }
      cut_part(part);
    }
  }

  [[nodiscard]] Corner from_of(const std::vector<std::uint32_t>& first,
                               std::size_t diagonal) const {
    return static_cast<Corner>(std::upper_bound(first.begin(), first.end(), diagonal) -
                               first.begin() - 1);
  }

  // From the polygon's next side on, against the clock.
  void sort_around(Corner v, std::span<Corner> to) const {
    const Corner start = next(v);
    const auto half = [&](Corner b) {
      const double side = turn(v, start, b);
      if (side != 0) return side > 0 ? 0 : 1;
      const double along = (at_[start][0] - at_[v][0]) * (at_[b][0] - at_[v][0]) +
                           (at_[start][1] - at_[v][1]) * (at_[b][1] - at_[v][1]);
      return along > 0 ? 0 : 1;
    };
    std::sort(to.begin(), to.end(), [&](Corner a, Corner b) {
      pace_();
      const int half_a = half(a);
      const int half_b = half(b);
      if (half_a != half_b) return half_a < half_b;
      const double side = turn(v, a, b);
      return side != 0 ? side > 0 : a < b;
    });
  }

  struct Waiting {
    Corner corner;
    bool lower;
  };

  // A part in positive sense: its lower chain leads to the right.
  void cut_part(const std::vector<Corner>& part) {
    if (part.size() < 3) return;
    const auto left = [&](Corner a, Corner b) {
      pace_();
      return left_of(a, b);
    };
    const auto begin =
        static_cast<std::size_t>(std::min_element(part.begin(), part.end(), left) - part.begin());
    std::vector<Waiting> sorted;
    std::size_t lower = begin;
    std::size_t upper = begin;
    const std::size_t size = part.size();
    sorted.push_back({part[begin], true});
    while (sorted.size() < size) {
      pace_();
      const std::size_t down = (lower + 1) % size;
      const std::size_t up = (upper + size - 1) % size;
      const bool take_lower = left_of(part[down], part[up]) || down == up;
      sorted.push_back({part[take_lower ? down : up], take_lower});
      (take_lower ? lower : upper) = take_lower ? down : up;
    }
    std::vector<Waiting> stack{sorted[0], sorted[1]};
    stack[0].lower = sorted[1].lower;
    for (std::size_t i = 2; i < size; ++i) {
      pace_();
      Waiting now = sorted[i];
      if (i + 1 == size) now.lower = !stack.back().lower;
      if (now.lower != stack.back().lower) {
        for (std::size_t k = 1; k < stack.size(); ++k)
          add(stack[k - 1].corner, stack[k].corner, now);
        stack = {{stack.back().corner, now.lower}, now};
        continue;
      }
      while (stack.size() > 1) {
        const Corner a = stack[stack.size() - 2].corner;
        const double side = turn(a, stack.back().corner, now.corner);
        if (now.lower ? side <= 0 : side >= 0) break;
        // Of the same chain: seen from the other side.
        add(a, stack.back().corner, {now.corner, !now.lower});
        stack.pop_back();
      }
      stack.push_back(now);
    }
  }

  // Of two corners of one chain, from left to right, and one of the other.
  void add(Corner a, Corner b, Waiting other) {
    pace_();
    if (other.lower) {
      triangles_.push_back({a, other.corner, b});
    } else {
      triangles_.push_back({a, b, other.corner});
    }
  }

  std::span<const PlanePoint> at_;
  Corner count_;
  Pace& pace_;
  std::vector<std::array<std::uint32_t, 3>>& triangles_;
  std::vector<Corner> rank_;    // of each corner, from the left
  std::vector<Corner> order_;   // corners by rank
  std::vector<Corner> helper_;  // of each edge the last corner that can see it from above
  std::vector<bool> is_merge_;
  Edges below_;
  std::vector<typename Edges::iterator> place_;
  std::vector<std::array<Corner, 2>> diagonals_;
};

}  // namespace

void cut_by_sweep(std::span<const PlanePoint> corners, Pace& pace,
                  std::vector<std::array<std::uint32_t, 3>>& triangles) {
  MonotoneCut(corners, pace, triangles).run();
}

}  // namespace winnow
