// Means of attributes by cell and by number: exact whatever is spilled, set aside or not finite.
#include "cluster/attribute_means.hpp"

#include "io/arena.hpp"
#include "support/job.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace winnow::test {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

CarriedAttributes numbers(std::size_t count, double largest) {
  CarriedAttributes carried;
  for (std::size_t k = 0; k < count; ++k) {
    carried.attributes.push_back({"a" + std::to_string(k), NumberType::float64});
    carried.largest.push_back(largest);
  }
  return carried;
}

// Faces whose corners all have one number, for each attribute one more.
std::unique_ptr<FaceBatch> batch_of(std::size_t attributes) {
  auto batch = std::make_unique<FaceBatch>();
  batch->count = FaceBatch::capacity;
  batch->status.fill(FaceStatus::good);
  batch->attributes.resize(3 * attributes * FaceBatch::capacity);
  return batch;
}

void set(FaceBatch& batch, std::size_t attributes, std::size_t face, double value) {
  for (std::size_t k = 0; k < attributes; ++k) {
    for (std::size_t c = 0; c < 3; ++c)
      batch.attributes[(3 * k + c) * FaceBatch::capacity + face] = value + static_cast<double>(k);
  }
}

}  // namespace

TEST_CASE("weights beyond what a sum holds are set aside and counted") {
  TestJob test;
  in_arena(test.job, [&] {
    const auto means = AttributeMeans::make(test.job, numbers(2, 10), AttributeMeans::Keys::cells,
                                            {AttributeMemory::smallest_table(16, 2), 16});
    const auto batch = batch_of(2);
    const auto corners = std::make_unique<CornerSums>();
    for (std::size_t i = 0; i < batch->count; ++i) {
      set(*batch, 2, i, i % 4 == 3 ? not_a_number : static_cast<double>(i % 4));
      corners->kind[i] = one_cell;
      for (std::size_t c = 0; c < 3; ++c) corners->weight[c][i] = 1 << weight_limit_bits;
    }
    // 2^44 in all.
    for (int repeat = 0; repeat < 200; ++repeat) means->add(*batch, *corners);
    std::array<double, 2> found{};
    means->finish()->find(0, found);
    CHECK(found == std::array{1.0, 2.0});
  });
}

TEST_CASE("means by number are those of all corners whatever is spilled") {
  for (const std::size_t attributes : {1U, 6U, 16U}) {
    CAPTURE(attributes);
    TestJob test;
    in_arena(test.job, [&] {
      constexpr std::uint64_t most = 120'000;
      const auto means =
          AttributeMeans::make(test.job, numbers(attributes, 100), AttributeMeans::Keys::numbers,
                               {AttributeMemory::smallest_table(16, attributes), 16});
      const auto batch = batch_of(attributes);
      Random random(11);
      std::vector<double> sum(most), count(most);
      for (int face = 0; face < 100'000; ++face) {
        const auto value = static_cast<double>(random.below(64));
        set(*batch, attributes, 0, value);
        std::array<std::uint64_t, 3> corner{};
        for (std::uint64_t& number : corner) {
          number = random.below(most);
          sum[number] += value;
          ++count[number];
        }
        means->add(*batch, 0, corner);
        if (means->wants_to_spill()) means->spill();
      }
      CHECK(test.job.scratch.written() > 0);
      std::vector<double> found(attributes);
      const std::unique_ptr<AttributeCursor> cursor = means->finish();
      std::uint64_t wrong = 0;
      for (std::uint64_t number = 0; number < most; ++number) {
        cursor->find(number, found);
        for (std::size_t k = 0; k < attributes; ++k) {
          const double mean = sum[number] / count[number] + static_cast<double>(k);
          wrong += count[number] == 0 ? found[k] != 0 : !(std::abs(found[k] - mean) < 1e-13);
        }
      }
      CHECK(wrong == 0);
    });
  }
}

}  // namespace winnow::test
