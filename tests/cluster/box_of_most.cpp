// A few positions far off do not count, and the order in which threads read the others does not
// either.
#include "cluster/resolution.hpp"
#include "io/arena.hpp"
#include "read/formats.hpp"
#include "support/reading.hpp"
#include "support/shape_files.hpp"
#include "support/shape_measures.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

Box box_of_most(const Shape& shape, unsigned threads) {
  TestJob test({.threads = threads});
  constexpr std::size_t small_batch = 256;
  const std::unique_ptr<MeshReader> reader =
      open_reader(test.job, std::make_unique<MemorySource>(ply_of(shape, Numbers::doubles)),
                  Format::automatic, Access::repeatedly, {usual_vertex_memory, small_batch});
  return in_arena(test.job,
                  [&] { return measure_box_of_most(test.job, *reader, shape.vertices.size()); });
}

}  // namespace

TEST_CASE("the box of most leaves out a vertex far off, with any threads the same",
          "[same_bytes]") {
  for (const std::size_t n : {40, 80}) {
    const Shape shape = turned(shapes::far_vertex(n, 3e7), 0.4);
    const Box one = box_of_most(shape, 1);
    CHECK(box_of(shape).longest_side() > 1e6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // The ball, and as much again on either side.
      CHECK(one.low[axis] > -3.01);
      CHECK(one.low[axis] < -0.99);
      CHECK(one.high[axis] < 3.01);
      CHECK(one.high[axis] > 0.99);
    }
    for (const unsigned threads : {2, 7, 16}) {
      for (int time = 0; time < 5; ++time) {
        const Box more = box_of_most(shape, threads);
        CHECK(more.low == one.low);
        CHECK(more.high == one.high);
      }
    }
  }
}

TEST_CASE("the box of most is that of all where none lies far off") {
  const Shape shape = shapes::soup(1000);
  const Box all = box_of(shape);
  const Box most = box_of_most(shape, 4);
  CHECK(most.low == all.low);
  CHECK(most.high == all.high);
}

}  // namespace winnow::test
