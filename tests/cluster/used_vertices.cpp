// Which vertices good faces have, with and without room for a bit each.
#include "cluster/used_vertices.hpp"

#include "io/arena.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/reading.hpp"
#include "support/shape_files.hpp"
#include "support/sources.hpp"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Faces that jump over all vertices; one in four repeats a corner.
Shape scattered(std::uint32_t vertices, std::size_t faces) {
  Random random(11);
  Shape shape;
  for (std::uint32_t i = 0; i < vertices; ++i)
    shape.vertices.push_back({static_cast<double>(i), static_cast<double>(i % 1000), 0});
  const auto any = [&] { return static_cast<std::uint32_t>(random.below(vertices)); };
  for (std::size_t i = 0; i < faces; ++i) {
    const std::uint32_t corner = any();
    shape.faces.push_back({corner, any(), i % 4 == 0 ? corner : any()});
  }
  return shape;
}

// `left`: of the budget, once the input is known.
void check_used(const Shape& shape, std::uint64_t left, bool in_scratch) {
  std::vector<bool> want(shape.vertices.size(), false);
  for (const auto& face : shape.faces) {
    if (face[0] == face[1] || face[0] == face[2] || face[1] == face[2]) continue;
    for (const std::uint32_t corner : face) want[corner] = true;
  }
  TestJob test;
  Job& job = test.job;
  in_arena(job, [&] {
    const auto reader =
        open_reader(job, std::make_unique<MemorySource>(ply_of(shape)), Format::automatic,
                    Access::repeatedly, {usual_vertex_memory, 8192});
    read_faces(job, *reader);
    const std::uint64_t before = job.scratch.written();
    const Reservation held = job.budget.reserve(job.budget.left() - left, "a test");
    const UsedVertices used(job, *reader, shape.vertices.size());
    CHECK((job.scratch.written() > before) == in_scratch);
    UsedVertices::Reader asked(used);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < want.size(); ++i) wrong += asked.has(i) == want[i] ? 0 : 1;
    CHECK(wrong == 0);
    CHECK_FALSE(asked.has(want.size() + 1'000'000));
  });
}

}  // namespace

TEST_CASE("the vertices of good faces are known, whatever the memory") {
  const Shape shape = scattered(1'200'000, 150'000);
  check_used(shape, 64 << 20, false);
  check_used(shape, 320 << 10, true);
}

}  // namespace winnow::test
