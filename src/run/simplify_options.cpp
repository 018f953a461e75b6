#include "run/simplify_options.hpp"

#include <winnow/error.hpp>

#include "base/morton.hpp"
#include "base/text.hpp"

#include <cmath>
#include <utility>

namespace winnow {

Refine cost_of(const SimplifyOptions& options) {
  return options.refine.value_or(options.cell || options.grid ? Refine::none : Refine::quadric);
}

void check(const SimplifyOptions& options) {
  const int given = int{options.cell.has_value()} + int{options.grid.has_value()} +
                    int{options.faces.has_value()} + int{options.ratio.has_value()} +
                    int{options.error.has_value()} + int{options.relative_error.has_value()};
  if (given != 1) {
    throw Error(ErrorKind::usage,
                "say how fine the result shall be with exactly one of --faces, --ratio, --error, "
                "--cell and --grid");
  }
  if (options.cell && !(*options.cell > 0 && std::isfinite(*options.cell))) {
    throw Error(ErrorKind::usage, "--cell takes a length above 0, not " + shortest(*options.cell));
  }
  if (options.grid && (*options.grid < 1 || *options.grid > axis_cells)) {
    throw Error(ErrorKind::usage,
                "--grid takes 1 to 2,097,152 cells, not " + grouped(*options.grid));
  }
  if (options.faces && *options.faces < 4)
    throw Error(ErrorKind::usage, "--faces takes at least 4");
  if (options.ratio && !(*options.ratio > 0 && *options.ratio <= 1)) {
    throw Error(ErrorKind::usage, "--ratio takes a part above 0 and at most 1 (or 100%), not " +
                                      shortest(*options.ratio));
  }
  if (options.error && !(*options.error > 0 && std::isfinite(*options.error))) {
    throw Error(ErrorKind::usage,
                "--error takes a length above 0, not " + shortest(*options.error));
  }
  if (options.relative_error && !(*options.relative_error > 0 && *options.relative_error < 1)) {
    throw Error(ErrorKind::usage,
                "--error takes a part of the diagonal above 0 and below 100%, not " +
                    shortest(100 * *options.relative_error) + "%");
  }
  if (options.weld && !(*options.weld > 0 && std::isfinite(*options.weld)))
    throw Error(ErrorKind::usage, "--weld takes a length above 0, not " + shortest(*options.weld));
  if (options.relative_weld && !(*options.relative_weld > 0 && *options.relative_weld < 1)) {
    throw Error(ErrorKind::usage,
                "--weld takes a part of the diagonal above 0 and below 100%, not " +
                    shortest(100 * *options.relative_weld) + "%");
  }
  if (options.weld && options.relative_weld)
    throw Error(ErrorKind::usage, "--weld takes a length or a part of the diagonal, not both");
  if (options.crop) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::pair((*options.crop)[0][axis], (*options.crop)[1][axis]);
      if (!(std::isfinite(low) && std::isfinite(high) && low <= high))
        throw Error(ErrorKind::usage, "--crop takes the low and then the high corner of a box");
    }
  }
  const bool by_error = options.error || options.relative_error;
  if (by_error && options.refine.value_or(Refine::quadric) != Refine::quadric) {
    throw Error(ErrorKind::usage,
                "--error goes with --refine quadric alone: the other costs are no distances");
  }
  if ((options.cell || options.grid) && options.refine.value_or(Refine::none) != Refine::none) {
    throw Error(ErrorKind::usage,
                "--cell and --grid only cluster; --refine goes with --faces, --ratio or --error");
  }
  if (options.detail && !(*options.detail > 1)) {
    throw Error(ErrorKind::usage,
                "--detail takes a number above 1, or full, not " + shortest(*options.detail));
  }
  if (options.detail && std::isfinite(*options.detail) && by_error) {
    throw Error(
        ErrorKind::usage,
        "with --error the error says how much is clustered; --detail can only be full there");
  }
  if (options.detail && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "--detail says what refinement starts from; it has no meaning without");
  }
  if (options.borders == Borders::keep && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "--boundary keep goes with refinement; clustering moves every vertex");
  }
  if (options.topology == Topology::free && cost_of(options) != Refine::quadric) {
    throw Error(ErrorKind::usage,
                "--topology free goes with --refine quadric alone: the other costs remove vertices "
                "inside of "
                "a surface");
  }
  if (options.keep_pieces && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "--keep-pieces goes with refinement; clustering joins what is near");
  }
  if (options.max_normal_deviation != SimplifyOptions{}.max_normal_deviation &&
      cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "--max-normal-deviation bounds what refinement does; it has no meaning without");
  }
  if (!(options.max_normal_deviation > 0 && options.max_normal_deviation <= 90)) {
    throw Error(ErrorKind::usage,
                "--max-normal-deviation takes an angle above 0 and at most 90 degrees, not " +
                    shortest(options.max_normal_deviation));
  }
}

bool welds(const SimplifyOptions& options) {
  return options.weld || options.relative_weld;
}

Access access_for(const SimplifyOptions& options) {
  if (welds(options)) return Access::repeatedly;
  return options.cell ? Access::once : Access::repeatedly;
}

CellNeeds needs_of(const SimplifyOptions& options, const AttributeChoice& choice) {
  return {options.placement == Placement::quadric, choice.carried.size(), welds(options)};
}

}  // namespace winnow
