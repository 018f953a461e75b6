// Runs of simplify() on shapes, in any pose, as files of floats or doubles.
#pragma once

#include <winnow/compare.hpp>
#include <winnow/simplify.hpp>

#include "support/attributes.hpp"
#include "support/files.hpp"
#include "support/refining.hpp"
#include "support/shape_files.hpp"
#include "support/shape_measures.hpp"

#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

namespace winnow::test {

struct Pose {
  double angle = 0;
  Numbers numbers = Numbers::floats;
};

// Passes of fitting that WINNOW_TEST_FIT in the environment asks for.
inline unsigned asked_passes() {
  const char* asked = std::getenv("WINNOW_TEST_FIT");
  return asked == nullptr ? 0 : static_cast<unsigned>(std::strtoul(asked, nullptr, 10));
}

// check(pose) for every pose; for two of three angles where everything is fitted.
template <typename Check>
void for_each_pose(const Check& check) {
  for (const double angle : {0.0, 0.4, 1.1}) {
    if (angle == 0.4 && asked_passes() > 0) continue;
    for (const Numbers numbers : {Numbers::floats, Numbers::doubles}) {
      INFO("turned by " << angle << ", " << (numbers == Numbers::doubles ? "doubles" : "floats"));
      check(Pose{angle, numbers});
    }
  }
}

// A binary PLY that the program wrote.
inline Shape read_shape(const std::string& path) {
  AttributedMesh mesh = read_attributed(path);
  return {std::move(mesh.positions), std::move(mesh.faces)};
}

struct RefinedShape {
  SimplifyReport report;
  Shape input;   // as it was stored
  Shape output;  // as it was written
  Defects defects;
  CompareReport compared{};  // only where it was asked for
};

// Everything is fitted that can be, where the environment asks for it.
inline SimplifyOptions fitted_where_asked(SimplifyOptions options) {
  if (asked_passes() > 0 && options.target.of_count() &&
      options.refine.value_or(Refine::quadric) == Refine::quadric)
    options.fit = asked_passes();
  return options;
}

// In a pose. `samples`: of the comparison; 0: none.
inline RefinedShape refine_shape(const Shape& shape, const Pose& pose, SimplifyOptions options,
                                 std::uint64_t samples = 0) {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  RefinedShape out;
  out.input = as_stored(turned(shape, pose.angle), pose.numbers);
  write_file(input, ply_of(out.input, pose.numbers));
  Context context;
  context.threads = 2;
  context.scratch = directory.path();
  out.report = simplify(context, input, output, fitted_where_asked(std::move(options)));
  out.output = read_shape(output);
  out.defects = defects_of(out.output.faces);
  if (samples > 0) {
    CompareOptions how;
    how.samples = samples;
    out.compared = compare(context, input, output, how);
  }
  return out;
}

inline SimplifyOptions to_count(std::uint64_t faces) {
  SimplifyOptions options;
  options.target = Target::faces(faces);
  return options;
}

inline SimplifyOptions to_error(double error) {
  SimplifyOptions options;
  options.target = Target::error(error);
  return options;
}

inline SimplifyOptions to_relative_error(double error) {
  SimplifyOptions options;
  options.target = Target::error(Distance::of_diagonal(error));
  return options;
}

// How far apart the numbers of a kind are, at the farthest coordinate of a shape.
inline double spacing_of(const Shape& shape, Numbers numbers) {
  double largest = 0;
  for (const Point& p : shape.vertices) {
    for (const double x : p) largest = std::max(largest, std::abs(x));
  }
  return largest * (numbers == Numbers::doubles ? std::numeric_limits<double>::epsilon()
                                                : double{std::numeric_limits<float>::epsilon()});
}

inline bool is_closed(const RefinedShape& refined) {
  const Defects& found = refined.defects;
  return found.boundary_edges + found.crowded + found.discords + found.duplicates +
             found.degenerate ==
         0;
}

}  // namespace winnow::test
