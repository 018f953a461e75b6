// Vertices by the price of what they propose: the cheapest first, and of equally cheap ones the lowest
// number.
#pragma once

#include "decimate/tile_mesh.hpp"

#include <cstddef>
#include <vector>

namespace winnow {

// A heap of four children a node that knows where each vertex stands, so that a price can change.
class PriceQueue {
 public:
  struct Offer {
    double price = 0;
    VertexNumber vertex = no_number;
    // Which is less is a coin toss: no branches.
    [[nodiscard]] bool before(const Offer& other) const {
      return (price < other.price) | ((price == other.price) & (vertex < other.vertex));
    }
  };

  explicit PriceQueue(VertexNumber vertices) : place_(vertices, no_number) { heap_.reserve(vertices); }

  static constexpr std::uint64_t memory(std::uint64_t vertices) {
    return vertices * (sizeof(Offer) + sizeof(std::uint32_t));
  }

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] const Offer& top() const { return heap_.front(); }
  [[nodiscard]] bool holds(VertexNumber v) const { return place_[v] != no_number; }
  [[nodiscard]] double price(VertexNumber v) const { return heap_[place_[v]].price; }

  // Many vertices at once; then order() once.
  void append(VertexNumber v, double price) {
    place_[v] = static_cast<std::uint32_t>(heap_.size());
    heap_.push_back({price, v});
  }
  void order() {
    for (std::size_t i = heap_.size() / children + 1; i-- > 0;) {
      if (i < heap_.size()) sink(i, heap_[i]);
    }
  }

  void set(VertexNumber v, double price) {
    const Offer offer{price, v};
    if (!holds(v)) {
      heap_.emplace_back();
      rise(heap_.size() - 1, offer);
    } else if (offer.before(heap_[place_[v]])) {
      rise(place_[v], offer);
    } else {
      sink(place_[v], offer);
    }
  }

  void remove(VertexNumber v) {
    if (!holds(v)) return;
    const std::size_t at = place_[v];
    place_[v] = no_number;
    const Offer last = heap_.back();
    heap_.pop_back();
    if (at == heap_.size()) return;
    if (at > 0 && last.before(heap_[(at - 1) / children])) {
      rise(at, last);
    } else {
      sink(at, last);
    }
  }

 private:
  static constexpr std::size_t children = 4;

  void put(std::size_t at, const Offer& offer) {
    heap_[at] = offer;
    place_[offer.vertex] = static_cast<std::uint32_t>(at);
  }

  void rise(std::size_t at, const Offer& offer) {
    while (at > 0 && offer.before(heap_[(at - 1) / children])) {
      put(at, heap_[(at - 1) / children]);
      at = (at - 1) / children;
    }
    put(at, offer);
  }

  void sink(std::size_t at, const Offer offer) {
    for (;;) {
      const std::size_t first = at * children + 1;
      if (first >= heap_.size()) break;
      std::size_t least = first;
      const std::size_t end = first + children < heap_.size() ? first + children : heap_.size();
      for (std::size_t child = first + 1; child < end; ++child) {
        least = heap_[child].before(heap_[least]) ? child : least;
      }
      if (!heap_[least].before(offer)) break;
      put(at, heap_[least]);
      at = least;
    }
    put(at, offer);
  }

  std::vector<Offer> heap_;
  std::vector<std::uint32_t> place_;
};

}  // namespace winnow
