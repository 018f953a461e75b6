// What a pass for a few places may leave out: nothing that lies there.
#include "cluster/batch_boxes.hpp"

#include "support/job.hpp"
#include "support/random.hpp"

#include <memory>
#include <vector>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

constexpr std::uint64_t all_faces = 100'000;

// Face f lies at f along the first axis; of every so many faces the place is not known.
void add_all(BatchBoxes& boxes, std::uint64_t unknown, bool in_order) {
  auto batch = std::make_unique<FaceBatch>();
  const std::vector<std::uint32_t> numbers(FaceBatch::capacity);
  for (batch->first = 0; batch->first < all_faces; batch->first += batch->count) {
    batch->count = std::min<std::uint64_t>(FaceBatch::capacity, all_faces - batch->first);
    batch->numbers = in_order ? nullptr : numbers.data();
    Box box;
    const auto first = static_cast<double>(batch->first);
    box.add(Point{first, 0, 0});
    box.add(Point{first + static_cast<double>(batch->count) - 1, 0, 0});
    const bool known = unknown == 0 || batch->first % unknown >= batch->count;
    boxes.add(*batch, known ? box : Box{});
  }
}

}  // namespace

TEST_CASE("batches are left out only where none of their faces lies at a place") {
  TestJob test;
  BatchBoxes boxes(test.job);
  add_all(boxes, 0, true);
  Random random(1);
  int left_out = 0;
  for (int i = 0; i < 2000; ++i) {
    RawBatch batch;
    batch.first = random.below(all_faces - 1);
    batch.count = 1 + random.below(std::min<std::uint64_t>(9000, all_faces - batch.first));
    std::vector<Box> places;
    bool meets = false;
    for (std::uint64_t n = random.below(3); n > 0; --n) {
      const std::uint64_t at = random.below(all_faces);
      Box& place = places.emplace_back();
      place.add(Point{static_cast<double>(at), 0, 0});
      meets |= at >= batch.first && at < batch.first + batch.count;
    }
    const bool may = boxes.may_meet(batch, places);
    if (meets) CHECK(may);
    left_out += may ? 0 : 1;
  }
  CHECK(left_out > 1000);
}

TEST_CASE("batches whose faces lie nowhere that is known are never left out") {
  TestJob test;
  BatchBoxes unknown(test.job);
  add_all(unknown, 1000, true);
  BatchBoxes shuffled(test.job);
  add_all(shuffled, 0, false);
  for (std::uint64_t first = 0; first + 100 < all_faces; first += 997) {
    RawBatch batch;
    batch.first = first;
    batch.count = 100;
    CHECK(unknown.may_meet(batch, {}));
    CHECK(shuffled.may_meet(batch, {}));
  }
}

}  // namespace winnow::test
