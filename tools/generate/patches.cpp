#include "generate/patches.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

namespace {

enum class Side : std::uint8_t { low, inside, high };
constexpr std::array sides{Side::low, Side::inside, Side::high};

// Which patch of a square: on which side along b and along c.
struct Piece {
  Place place;
  std::array<std::size_t, 2> axis;
  std::array<bool, 2> extends;

  Piece(const Blocks::Square& square, Side side_b, Side side_c)
      : place(square.place),
        axis{(square.axis + std::size_t{1}) % 3, (square.axis + std::size_t{2}) % 3},
        extends{side_b == Side::inside, side_c == Side::inside} {
    if (side_b == Side::high) ++place[axis[0]];
    if (side_c == Side::high) ++place[axis[1]];
  }
  [[nodiscard]] std::size_t dimension() const {
    return (extends[0] ? 1U : 0U) + (extends[1] ? 1U : 0U);
  }

  // The same for all squares that share it: a bit for each axis it extends along.
  [[nodiscard]] std::size_t direction() const {
    return (extends[0] ? std::size_t{1} << axis[0] : 0U) +
           (extends[1] ? std::size_t{1} << axis[1] : 0U);
  }
};

class Numbering {
 public:
  Numbering(const Blocks& blocks, const Pieces& pieces)
      : blocks_(blocks), pieces_(pieces), squares_(blocks.boundary()) {
    const std::size_t places =
        blocks.planes(0).size() * blocks.planes(1).size() * blocks.planes(2).size();
    patch_of_.assign(8 * places, none);
  }

  Patches run() {
    for (std::size_t dimension = 0; dimension < 3; ++dimension) {
      for (const Blocks::Square& square : squares_) {
        for (const Side side_c : sides) {
          for (const Side side_b : sides) {
            const Piece part(square, side_b, side_c);
            if (part.dimension() == dimension && entry(part) == none) add(part);
          }
        }
      }
    }
    for (const Blocks::Square& square : squares_) add(square);
    return std::move(result_);
  }

 private:
  static constexpr std::size_t none = SIZE_MAX;

  std::size_t& entry(const Piece& part) {
    const std::size_t place =
        (part.place[2] * blocks_.planes(1).size() + part.place[1]) * blocks_.planes(0).size() +
        part.place[0];
    return patch_of_[8 * place + part.direction()];
  }

  [[nodiscard]] std::uint64_t pieces(std::size_t axis, const Place& place) const {
    return pieces_[axis][place[axis]];
  }

  void add(const Piece& part) {
    entry(part) = result_.patches.size();
    Patch patch{result_.vertices, 1, part.axis, {}, {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      patch.origin[axis] = blocks_.planes(axis)[part.place[axis]];
    std::uint64_t count = 1;
    for (std::size_t n = 0; n < 2; ++n) {
      if (!part.extends[n]) continue;
      const std::size_t axis = part.axis[n];
      const std::uint64_t cuts = pieces(axis, part.place);
      const std::vector<double>& planes = blocks_.planes(axis);
      const std::uint32_t gap = part.place[axis];
      patch.step[n] = (planes[gap + 1] - planes[gap]) / static_cast<double>(cuts);
      patch.origin[axis] += patch.step[n];
      if (n == 0) patch.row = std::max<std::uint64_t>(cuts - 1, 1);
      count *= cuts - 1;
    }
    result_.vertices += count;
    result_.patches.push_back(patch);
  }

  void add(const Blocks::Square& square) {
    const Piece inside(square, Side::inside, Side::inside);
    Sheet sheet{result_.faces,
                {pieces(inside.axis[0], square.place), pieces(inside.axis[1], square.place)},
                square.upwards,
                {}};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t b = 0; b < 3; ++b) {
        sheet.patch_begin[c][b] = result_.patches[entry(Piece(square, sides[b], sides[c]))].begin;
      }
    }
    result_.faces += 2 * sheet.pieces[0] * sheet.pieces[1];
    result_.sheets.push_back(sheet);
  }

  const Blocks& blocks_;
  const Pieces& pieces_;
  std::vector<Blocks::Square> squares_;
  std::vector<std::size_t> patch_of_;  // by lowest corner, then direction
  Patches result_;
};

}  // namespace

Patches number_patches(const Blocks& blocks, const Pieces& pieces) {
  return Numbering(blocks, pieces).run();
}

}  // namespace winnow
