// The kernels of every instruction set find the same areas.
#include "cluster/kernel/area_kernel.hpp"
#include "read/face_batch.hpp"
#include "support/random.hpp"
#include "support/runnable.hpp"
#include "support/surfaces.hpp"

#include <bit>
#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

AreaInput input_of(const FaceBatch& faces) {
  AreaInput input{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      input.single_position[corner][axis] = faces.single_position[corner][axis].data();
      input.position[corner][axis] = faces.position[corner][axis].data();
    }
  }
  input.single = faces.single;
  input.count = faces.count;
  return input;
}

std::unique_ptr<FaceBatch> random_faces(Random& random, bool single) {
  auto faces = std::make_unique<FaceBatch>();
  faces->single = single;
  faces->count = random.between(1, FaceBatch::capacity);
  const double size = std::pow(10, random.real(-6, 6));
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < faces->count; ++i) {
        const double place = size * random.real(-1, 1);
        faces->position[corner][axis].at(i) = place;
        faces->single_position[corner][axis].at(i) = static_cast<float>(place);
      }
    }
  }
  return faces;
}

}  // namespace

TEST_CASE("areas have the same bits by every kernel, and are right") {
  Random random(403);
  for (int round = 0; round < 200; ++round) {
    const std::unique_ptr<FaceBatch> faces = random_faces(random, round % 2 == 0);
    const AreaInput input = input_of(*faces);
    std::array<double, FaceBatch::capacity> right{};
    area_kernel_baseline.doubled_areas(input, right.data());
    double largest = 0;
    for (std::size_t i = 0; i < faces->count; ++i) {
      const Triangle face{faces->corner(0, i), faces->corner(1, i), faces->corner(2, i)};
      CHECK(right.at(i) == Approx(2 * length(area_vector(face))).epsilon(1e-9));
      largest = std::max(largest, right.at(i));
    }
    const double scale = std::exp2(30 - std::ilogb(largest));
    std::uint64_t right_units = 0;
    REQUIRE(area_kernel_baseline.add_up(right.data(), faces->count, scale, right_units));
    std::uint64_t ignored = 0;
    CHECK(!area_kernel_baseline.add_up(right.data(), faces->count, scale * 0x1p20, ignored));
    for (const auto& [name, kernel] : runnable(WINNOW_KERNELS(&area_kernel))) {
      CAPTURE(name);
      std::array<double, FaceBatch::capacity> got{};
      kernel->doubled_areas(input, got.data());
      bool same = true;
      for (std::size_t i = 0; i < faces->count; ++i)
        same = same &&
               std::bit_cast<std::uint64_t>(got.at(i)) == std::bit_cast<std::uint64_t>(right.at(i));
      CHECK(same);
      std::uint64_t units = 0;
      CHECK(kernel->add_up(got.data(), faces->count, scale, units));
      CHECK(units == right_units);
    }
  }
}

}  // namespace winnow
