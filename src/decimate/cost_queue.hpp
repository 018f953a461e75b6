// Vertices by the cost of what they propose: the cheapest first, and of equally cheap ones the
// lowest number.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winnow {

// A heap of four children a node that knows where each vertex stands, so that a cost can change.
// Which of two offers is less is a coin toss, so both are one whole number, compared without
// branches.
class CostQueue {
 public:
  struct Offer {
    double cost = 0;
    VertexNumber vertex = no_number;
  };

  explicit CostQueue(VertexNumber vertices) : place_(vertices, no_number) {
    heap_.reserve(vertices);
  }

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (sizeof(Key) + sizeof(std::uint32_t));
  }

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] Offer top() const { return {cost_of(heap_.front()), vertex_of(heap_.front())}; }
  [[nodiscard]] bool holds(VertexNumber v) const { return place_[v] != no_number; }
  [[nodiscard]] double cost(VertexNumber v) const { return cost_of(heap_[place_[v]]); }

  // Many vertices at once; then order() once.
  void append(VertexNumber v, double cost) {
    place_[v] = static_cast<std::uint32_t>(heap_.size());
    heap_.push_back(key_of(cost, v));
  }
  void order() {
    for (std::size_t i = heap_.size() / children + 1; i-- > 0;) {
      if (i < heap_.size()) sink(i, heap_[i]);
    }
  }

  void set(VertexNumber v, double cost) {
    const Key key = key_of(cost, v);
    if (!holds(v)) {
      heap_.emplace_back();
      rise(heap_.size() - 1, key);
    } else if (key < heap_[place_[v]]) {
      rise(place_[v], key);
    } else {
      sink(place_[v], key);
    }
  }

  void remove(VertexNumber v) {
    if (!holds(v)) return;
    const std::size_t at = place_[v];
    place_[v] = no_number;
    const Key last = heap_.back();
    heap_.pop_back();
    if (at == heap_.size()) return;
    if (at > 0 && last < heap_[(at - 1) / children]) {
      rise(at, last);
    } else {
      sink(at, last);
    }
  }

 private:
  static constexpr std::size_t children = 4;
  __extension__ using Key = unsigned __int128;

  // Whole numbers in the order of the costs, above those of the vertices.
  static Key key_of(double cost, VertexNumber v) {
    const auto bits = std::bit_cast<std::uint64_t>(cost + 0.0);  // not -0, which equals 0
    const std::uint64_t order = bits ^ (bits >> 63 != 0 ? ~std::uint64_t{0} : sign);
    return Key{order} << 64 | v;
  }
  static double cost_of(Key key) {
    const auto order = static_cast<std::uint64_t>(key >> 64);
    return std::bit_cast<double>(order ^ (order >> 63 != 0 ? sign : ~std::uint64_t{0}));
  }
  static VertexNumber vertex_of(Key key) { return static_cast<VertexNumber>(key); }
  static constexpr std::uint64_t sign = std::uint64_t{1} << 63;

  void put(std::size_t at, Key key) {
    heap_[at] = key;
    place_[vertex_of(key)] = static_cast<std::uint32_t>(at);
  }

  void rise(std::size_t at, Key key) {
    while (at > 0 && key < heap_[(at - 1) / children]) {
      put(at, heap_[(at - 1) / children]);
      at = (at - 1) / children;
    }
    put(at, key);
  }

  void sink(std::size_t at, Key key) {
    for (std::size_t first = at * children + 1; first < heap_.size(); first = at * children + 1) {
      const std::size_t count = std::min(children, heap_.size() - first);
      std::size_t least = first;
      Key lowest = heap_[first];
      const auto look_at = [&](std::size_t child) {
        const Key other = heap_[child];
        const bool lower = other < lowest;
        least += (child - least) & (std::size_t{0} - std::size_t{lower});
        lowest = lower ? other : lowest;
      };
      if (count == children) {
        for (std::size_t i = 1; i < children; ++i) look_at(first + i);
      } else {
        for (std::size_t i = 1; i < count; ++i) look_at(first + i);
      }
      if (key < lowest) break;
      put(at, lowest);
      at = least;
    }
    put(at, key);
  }

  std::vector<Key> heap_;
  std::vector<std::uint32_t> place_;
};

}  // namespace winnow
