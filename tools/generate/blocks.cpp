#include "generate/blocks.hpp"

#include <algorithm>

namespace winnow {

Blocks::Blocks(std::array<std::vector<double>, 3> planes) : planes_(std::move(planes)) {
  filled_.resize(std::size_t{gaps(0)} * gaps(1) * gaps(2));
}

void Blocks::set(const Place& low, const Place& high, bool filled) {
  for (std::uint32_t z = low[2]; z < high[2]; ++z) {
    for (std::uint32_t y = low[1]; y < high[1]; ++y) {
      for (std::uint32_t x = low[0]; x < high[0]; ++x) filled_[index({x, y, z})] = filled;
    }
  }
}

std::vector<Blocks::Square> Blocks::boundary() const {
  std::vector<Square> squares;
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    const Place end{gaps(0) + (axis == 0), gaps(1) + (axis == 1), gaps(2) + (axis == 2)};
    for (std::uint32_t z = 0; z < end[2]; ++z) {
      for (std::uint32_t y = 0; y < end[1]; ++y) {
        for (std::uint32_t x = 0; x < end[0]; ++x) {
          const Place place{x, y, z};
          Place before = place;
          if (place[axis] > 0) --before[axis];
          const bool below = place[axis] > 0 && filled_[index(before)];
          const bool above = place[axis] < gaps(axis) && filled_[index(place)];
          if (below != above) squares.push_back({axis, below, place});
        }
      }
    }
  }
  return squares;
}

std::uint64_t count_pieces(const std::vector<Blocks::Square>& squares, const Pieces& pieces) {
  std::uint64_t sum = 0;
  for (const Blocks::Square& square : squares) {
    const std::size_t b = (square.axis + 1U) % 3;
    const std::size_t c = (square.axis + 2U) % 3;
    sum += pieces[b][square.place[b]] * pieces[c][square.place[c]];
  }
  return sum;
}

namespace {

Pieces pieces_of_length(const Blocks& blocks, double length) {
  Pieces pieces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double>& planes = blocks.planes(axis);
    for (std::size_t gap = 0; gap + 1 < planes.size(); ++gap) {
      const double ideal = (planes[gap + 1] - planes[gap]) / length;
      pieces[axis].push_back(std::max<std::uint64_t>(1, static_cast<std::uint64_t>(ideal + 0.5)));
    }
  }
  return pieces;
}

std::uint64_t apart(std::uint64_t a, std::uint64_t b) {
  return a > b ? a - b : b - a;
}

// One piece more or less in one gap, or in two: takes the change that comes nearest, as long as one
// helps.
void approach(const std::vector<Blocks::Square>& squares, std::uint64_t wanted, Pieces& pieces) {
  std::vector<std::uint64_t*> gaps;
  for (auto& axis : pieces) {
    for (std::uint64_t& gap : axis) gaps.push_back(&gap);
  }
  std::uint64_t miss = apart(count_pieces(squares, pieces), wanted);
  constexpr int most_changes = 30;
  for (int change = 0; change < most_changes && miss != 0; ++change) {
    std::uint64_t* best_a = nullptr;
    std::uint64_t* best_b = nullptr;
    std::uint64_t a_value = 0;
    std::uint64_t b_value = 0;
    const auto consider = [&](std::uint64_t* a, std::uint64_t* b) {
      const std::uint64_t now = apart(count_pieces(squares, pieces), wanted);
      if (now >= miss) return;
      miss = now;
      best_a = a;
      a_value = *a;
      best_b = b;
      b_value = b == nullptr ? 0 : *b;
    };
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      std::uint64_t* const a = gaps[i];
      const std::uint64_t a_before = *a;
      for (const int a_step : {1, -1}) {
        if (a_step < 0 && a_before == 1) continue;
        *a = a_step < 0 ? a_before - 1 : a_before + 1;
        consider(a, nullptr);
        for (std::size_t j = i + 1; j < gaps.size(); ++j) {
          std::uint64_t* const b = gaps[j];
          const std::uint64_t b_before = *b;
          *b = b_before + 1;
          consider(a, b);
          if (b_before > 1) {
            *b = b_before - 1;
            consider(a, b);
          }
          *b = b_before;
        }
      }
      *a = a_before;
    }
    if (best_a == nullptr) return;
    *best_a = a_value;
    if (best_b != nullptr) *best_b = b_value;
  }
}

}  // namespace

Pieces choose_pieces(const Blocks& blocks, std::uint64_t wanted) {
  const std::vector<Blocks::Square> squares = blocks.boundary();
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, blocks.planes(axis).back() - blocks.planes(axis).front());
  }
  double coarse = 2 * longest;
  double fine = longest;
  while (count_pieces(squares, pieces_of_length(blocks, fine)) < wanted) fine /= 2;
  constexpr int halvings = 50;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (coarse + fine) / 2;
    (count_pieces(squares, pieces_of_length(blocks, middle)) < wanted ? coarse : fine) = middle;
  }
  Pieces pieces = pieces_of_length(blocks, fine);
  approach(squares, wanted, pieces);
  return pieces;
}

}  // namespace winnow
