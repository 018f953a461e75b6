// A surface that is given in both senses: one of them is left everywhere, or both.
#include "support/random.hpp"
#include "support/refined_shape.hpp"

#include <algorithm>
#include <map>

namespace winnow::test {

namespace {

// Each edge is passed as often in the one direction as in the other.
bool balanced(const Shape& shape) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sum;
  for (const auto& face : shape.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = face[i];
      const std::uint32_t b = face[(i + 1) % 3];
      sum[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(sum.begin(), sum.end(), [](const auto& edge) { return edge.second == 0; });
}

}  // namespace

TEST_CASE("of a ball given in both senses one is left or both", "[shapes]") {
  for (const std::size_t n : {9, 17, 40}) {
    for (const bool inwards_first : {false, true}) {
      CAPTURE(n, inwards_first);
      Shape shape = shapes::double_sided(n);
      if (inwards_first) shape = inside_out(shape);
      const std::size_t pairs = shape.faces.size() / 2;
      for_each_pose([&](const Pose& pose) {
        for (const SimplifyOptions& options : {to_count(pairs), to_count(400), to_error(0.02)}) {
          const RefinedShape out = refine_shape(shape, pose, options);
          CAPTURE(out.output.faces.size());
          CHECK(out.defects.discords == 0);
          CHECK(out.defects.boundary_edges == 0);
          CHECK(balanced(out.output));
          if (out.defects.crowded == 0) {
            // The first face's sense.
            const double left = volume(out.output).value_or(0);
            CHECK((inwards_first ? -left : left) > 3);
            CHECK(out.report.merged_opposite_faces == pairs);
            CHECK_FALSE(out.report.notes.empty());
          }
        }
      });
    }
  }
}

TEST_CASE("of a ball whose pairs begin with either sense one is left or both", "[shapes]") {
  Random random(31);
  for (const std::size_t n : {7, 20}) {
    Shape shape = shapes::double_sided(n);
    const std::size_t pairs = shape.faces.size() / 2;
    for (std::size_t i = 0; i < pairs; ++i) {
      if (random.chance(0.5)) std::swap(shape.faces[i], shape.faces[pairs + i]);
    }
    for_each_pose([&](const Pose& pose) {
      for (const SimplifyOptions& options : {to_count(pairs), to_count(200), to_error(0.02)}) {
        const RefinedShape out = refine_shape(shape, pose, options);
        CHECK(out.defects.discords == 0);
        CHECK(out.defects.boundary_edges == 0);
        CHECK(balanced(out.output));
        CHECK(out.report.merged_opposite_faces == pairs);
      }
    });
  }
}

TEST_CASE("of a sheet given in both senses one is left or both", "[shapes]") {
  Shape shape = shapes::hills(20);
  const std::size_t pairs = shape.faces.size();
  const Shape other = inside_out(shape);
  // Each face is followed by its opposite.
  for (std::size_t i = 0; i < pairs; ++i)
    shape.faces.insert(shape.faces.begin() + static_cast<std::ptrdiff_t>(2 * i + 1),
                       other.faces[i]);
  for_each_pose([&](const Pose& pose) {
    for (const std::uint64_t faces : {pairs, std::size_t{200}}) {
      const RefinedShape out = refine_shape(shape, pose, to_count(faces));
      CHECK(out.defects.discords == 0);
      if (out.defects.crowded == 0) {
        CHECK(out.report.merged_opposite_faces == pairs);
        CHECK_FALSE(out.report.notes.empty());
        // All faces look to one side: seen from above their areas add up.
        double up = 0;
        for (const auto& face : out.output.faces) {
          const Triangle corners{out.output.vertices[face[0]], out.output.vertices[face[1]],
                                 out.output.vertices[face[2]]};
          up += dot(doubled_area(corners), turned(Point{0, 0, 1}, pose.angle)) / 2;
        }
        CHECK(std::abs(up) > 0.98);
      }
    }
  });
}

}  // namespace winnow::test
