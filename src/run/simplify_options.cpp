#include "run/simplify_options.hpp"

#include <winnow/error.hpp>

#include "options/check_ranges.hpp"
#include "options/level_targets.hpp"
#include "options/refuse_targets.hpp"

#include <cmath>

namespace winnow {

Refine cost_of(const SimplifyOptions& options) {
  return options.refine.value_or(options.target.of_cells() ? Refine::none : Refine::quadric);
}

namespace {

void check_levels(const SimplifyOptions& options) {
  if (options.coarser.empty()) return;
  if (cost_of(options) == Refine::none)
    throw Error(ErrorKind::usage,
                "several results of one run are made by refining; with cells or `refine` none each "
                "takes a run of its own");
  const std::vector<Target> targets = targets_of(options);
  for (std::size_t i = 1; i < targets.size(); ++i) {
    if (targets[i].kind() != targets[0].kind() || is_finer(targets[i], targets[i - 1]))
      throw Error(ErrorKind::usage,
                  "several targets are all of one kind, `faces`, `ratio` or `error`, and each is "
                  "coarser than the one before");
    const std::optional<Distance> error = targets[i].error();
    if (error && error->relative != targets[0].error()->relative)
      throw Error(ErrorKind::usage,
                  "several values of `error` are all lengths or all parts of the diagonal");
  }
}

}  // namespace

void check(const SimplifyOptions& options) {
  if (options.target.kind() == Target::Kind::none) refuse_targets();
  check_levels(options);
  check_ranges(simplify_options(), options);
  const bool by_error = options.target.error().has_value();
  if (by_error && !facts_of(options.refine.value_or(Refine::quadric)).bounds_error) {
    throw Error(ErrorKind::usage,
                "`error` goes with `refine` quadric alone: the other costs are no distances");
  }
  if (options.target.of_cells() && options.refine.value_or(Refine::none) != Refine::none) {
    throw Error(ErrorKind::usage,
                "`cell` and `grid` only cluster; `refine` goes with `faces`, `ratio` or `error`");
  }
  if (options.detail && std::isfinite(*options.detail) && by_error) {
    throw Error(
        ErrorKind::usage,
        "with `error` the error says how much is clustered; `detail` can only be full there");
  }
  if (options.detail && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "`detail` says what refinement starts from; it has no meaning without");
  }
  if (options.boundary == Boundary::keep && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "`boundary` keep goes with refinement; clustering moves every vertex");
  }
  if (options.topology == Topology::free && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "`topology` free goes with refinement; clustering keeps no topology");
  }
  if (options.keep_pieces && cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "`keep_pieces` goes with refinement; clustering joins what is near");
  }
  if (options.fit.value_or(0) > 0 &&
      !(options.target.of_count() && cost_of(options) == Refine::quadric)) {
    throw Error(ErrorKind::usage,
                "`fit` goes with `faces` or `ratio` and `refine` quadric; other results keep an "
                "error, a grid or vertices of the input");
  }
  if (options.max_normal_deviation != SimplifyOptions{}.max_normal_deviation &&
      cost_of(options) == Refine::none) {
    throw Error(ErrorKind::usage,
                "`max_normal_deviation` bounds what refinement does; it has no meaning without");
  }
}

unsigned fit_passes(const SimplifyOptions& options) {
  return static_cast<unsigned>(options.fit.value_or(0));
}

bool welds(const SimplifyOptions& options) {
  return options.weld.has_value();
}

Access access_for(const SimplifyOptions& options, bool map) {
  if (welds(options) || map) return Access::repeatedly;
  return options.target.cell() ? Access::once : Access::repeatedly;
}

CellNeeds needs_of(const SimplifyOptions& options, const AttributeSelection& choice) {
  return {options.placement == Placement::quadric, choice.carried.size(), welds(options)};
}

}  // namespace winnow
