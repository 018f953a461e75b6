// Clustering alone leaves open boundaries where they are.
#include "support/refined_shape.hpp"

#include <array>

namespace winnow::test {

namespace {

SimplifyOptions to_grid(std::uint64_t cells) {
  SimplifyOptions options;
  options.target = Target::grid(cells);
  return options;
}

SimplifyOptions to_clusters(std::uint64_t faces, Placement placement) {
  SimplifyOptions options = to_count(faces);
  options.refine = Refine::none;
  options.placement = placement;
  return options;
}

}  // namespace

TEST_CASE("open boundaries do not shrink where faces are clustered alone", "[shapes]") {
  for (const Shape& shape : {shapes::disc(200, 60), shapes::hills(120), shapes::strip(300, 0.15)}) {
    for_each_pose([&](const Pose& pose) {
      for (const SimplifyOptions& options :
           {to_grid(20), to_grid(33), to_clusters(700, Placement::quadric)}) {
        const RefinedShape out = refine_shape(shape, pose, options);
        CAPTURE(out.input.faces.size(), out.output.faces.size());
        CHECK(area(out.output) == Approx(area(out.input)).epsilon(0.01));
      }
    });
  }
}

TEST_CASE("a closed surface is clustered as if boundaries were unknown", "[shapes]") {
  // A hole in a side moves what is beside it, and nothing else.
  const Shape whole = shapes::thin_shell(30, 0.3);
  Shape open = whole;
  open.faces.erase(open.faces.begin());
  const RefinedShape a = refine_shape(whole, {}, to_grid(15));
  const RefinedShape b = refine_shape(open, {}, to_grid(15));
  std::size_t moved = 0;
  REQUIRE(a.output.vertices.size() == b.output.vertices.size());
  for (std::size_t v = 0; v < a.output.vertices.size(); ++v)
    moved += a.output.vertices[v] == b.output.vertices[v] ? 0 : 1;
  CHECK(moved <= 3);
}

}  // namespace winnow::test
