// Vertices by index: the same positions however they are kept, within the memory they were given.
#include "read/indexed/vertex_store.hpp"

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/ply_file.hpp"
#include "support/random.hpp"
#include "support/scratch_files.hpp"

#include <atomic>
#include <functional>
#include <thread>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

constexpr std::size_t vertex_count = 400'000;

const std::vector<test::Point>& some_points() {
  static const std::vector<test::Point> points = [] {
    test::Random random(320);
    return as_stored(test::random_polygons(random, vertex_count, 0, 3), {}).vertices;
  }();
  return points;
}

// Indices as faces have them: near each other, or anywhere.
std::uint32_t some_index(test::Random& random, std::uint32_t near, bool anywhere) {
  if (anywhere) return static_cast<std::uint32_t>(random.below(vertex_count));
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(vertex_count - 1, near + random.below(2000)));
}

VertexRange range_of(const std::array<std::vector<std::uint32_t>, 3>& index) {
  VertexRange range{UINT32_MAX, 0};
  for (const auto& corner : index) {
    for (const std::uint32_t i : corner)
      range = {std::min(range.lowest, i), std::max(range.highest, i)};
  }
  return range;
}

void check_lookups(const VertexStore& store) {
  test::Random random(321);
  const auto batch = std::make_unique<FaceBatch>();
  std::array<std::vector<std::uint32_t>, 3> index;
  for (int round = 0; round < 120; ++round) {
    const bool anywhere = round % 10 == 0;
    const std::size_t count = random.between(0, anywhere ? 40 : FaceBatch::capacity);
    const auto near = static_cast<std::uint32_t>(random.below(vertex_count));
    for (auto& corner : index) {
      corner.resize(count);
      for (std::uint32_t& i : corner) i = some_index(random, near, anywhere);
    }
    store.gather({index[0].data(), index[1].data(), index[2].data()}, range_of(index), count,
                 *batch);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t i = 0; i < count; ++i)
        REQUIRE(batch->corner(corner, i) == some_points()[index[corner][i]]);
    }
  }
  std::array<std::vector<double>, 3> out;
  for (auto& axis : out) axis.resize(500);
  for (int round = 0; round < 60; ++round) {
    const std::uint64_t first = random.below(vertex_count - 500);
    store.read(first, 500, {out[0].data(), out[1].data(), out[2].data()});
    for (std::size_t i = 0; i < 500; ++i)
      REQUIRE(test::Point{out[0][i], out[1][i], out[2][i]} == some_points()[first + i]);
  }
}

void keep_all(VertexStore& store, bool doubles) {
  store.begin_keeping(doubles);
  std::vector<double> xyz;
  for (const test::Point& p : some_points()) {
    xyz.insert(xyz.end(), p.begin(), p.end());
    if (xyz.size() < 3000) continue;
    store.keep(xyz);
    xyz.clear();
  }
  store.keep(xyz);
  store.finish_keeping();
}

}  // namespace

TEST_CASE("vertices that are kept are looked up from memory and from scratch") {
  for (const bool doubles : {false, true}) {
    for (const std::uint64_t limit :
         {std::uint64_t{64} << 20, std::uint64_t{1} << 20, std::uint64_t{0}}) {
      test::TestJob test;
      VertexStore store(test.job, limit);
      keep_all(store, doubles);
      CAPTURE(doubles, limit);
      CHECK(store.size() == vertex_count);
      CHECK(test.job.budget.used() <= limit + (1 << 20));
      check_lookups(store);
      store.release_memory();
      store.acquire_memory();
      check_lookups(store);
    }
  }
}

TEST_CASE(
    "a changed bit of vertices that are kept in scratch is noticed however they are looked up") {
  test::TestJob test;
  const std::set<int> before = test::descriptors();
  VertexStore store(test.job, std::uint64_t{1} << 20);
  keep_all(store, false);
  const test::OpenedFile damaged(test::opened_since(before).front());
  // All looks at it alone: what was looked at before is in memory.
  const auto rested = [&](const auto& look) {
    store.release_memory();
    store.acquire_memory();
    look();
  };
  const auto batch = std::make_unique<FaceBatch>();
  constexpr std::uint32_t v = 200'000;
  const std::array<std::uint32_t, 2> far{v, 1};
  const std::vector<std::function<void()>> looks{
      [&] {
        store.gather({&v, &v, &v}, {v, v}, 1, *batch);
      },
      [&] {
        store.gather({far.data(), far.data(), far.data()}, {1, v}, 2, *batch);
      },
      [&] {
        std::array<double, 3> xyz{};
        store.read(v, 1, {&xyz[0], &xyz[1], &xyz[2]});
      },
      [&] {
        std::array<std::byte, 12> record{};
        store.read_records(v, 1, record.data());
      },
      [&] { store.for_each_stretch([](const std::byte*, std::size_t) {}); }};
  for (const auto& look : looks) CHECK_NOTHROW(rested(look));
  damaged.flip(12 * std::uint64_t{v} + 5, 2);
  for (const auto& look : looks) {
    CHECK(test::error_of([&] { rested(look); }).kind() == ErrorKind::resources);
  }
  const std::uint32_t other = 1;
  CHECK_NOTHROW(store.gather({&other, &other, &other}, {other, other}, 1, *batch));
}

TEST_CASE("vertices in a mapped file are looked up whatever their records are like") {
  const test::Directory directory;
  struct Form {
    std::size_t stride;
    std::array<std::size_t, 3> offset;
    PlyType type;
    bool swapped;
  };
  for (const Form& form : std::vector<Form>{{12, {0, 4, 8}, PlyType::float32, false},
                                            {12, {0, 4, 8}, PlyType::float32, true},
                                            {13, {8, 0, 4}, PlyType::float32, false},
                                            {27, {3, 11, 19}, PlyType::float64, false},
                                            {24, {0, 8, 16}, PlyType::float64, true}}) {
    std::string bytes(7, '?');  // the records begin somewhere
    for (const test::Point& p : some_points()) {
      std::string record(form.stride, '#');
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<char, 8> value{};
        const auto single = static_cast<float>(p[axis]);
        const std::size_t size = form.type == PlyType::float32 ? 4 : 8;
        std::memcpy(value.data(), size == 4 ? static_cast<const void*>(&single) : &p[axis], size);
        if (form.swapped)
          std::reverse(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(size));
        record.replace(form.offset[axis], size, value.data(), size);
      }
      bytes += record;
    }
    test::write_file(directory.file("vertices"), bytes);
    for (const std::uint64_t limit : {std::uint64_t{64} << 20, std::uint64_t{2} << 20}) {
      test::TestJob test;
      VertexStore store(test.job, limit);
      store.map(directory.file("vertices"), 7, vertex_count,
                {form.stride, form.offset, {form.type, form.type, form.type}, form.swapped});
      CAPTURE(form.stride, form.swapped, limit);
      CHECK(store.size() == vertex_count);
      CHECK(test.job.budget.used() <= limit);
      check_lookups(store);
      store.release_memory();
      CHECK(test.job.budget.used() == 0);
      store.acquire_memory();
      check_lookups(store);
    }
  }
}

TEST_CASE("threads look vertices up at once while pages are dropped", "[threads]") {
  test::TestJob test;
  VertexStore store(test.job, std::uint64_t{1} << 20);
  keep_all(store, false);
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (std::uint64_t number = 0; number < 3; ++number) {
    threads.emplace_back([&, number] {
      test::Random random(330 + number);
      const auto batch = std::make_unique<FaceBatch>();
      std::vector<std::uint32_t> index(FaceBatch::capacity);
      for (int round = 0; round < 300; ++round) {
        const auto near = static_cast<std::uint32_t>(random.below(vertex_count));
        for (std::uint32_t& i : index) i = some_index(random, near, false);
        store.gather({index.data(), index.data(), index.data()}, range_of({index, index, index}),
                     index.size(), *batch);
        for (std::size_t i = 0; i < index.size(); ++i)
          wrong += batch->corner(1, i) == some_points()[index[i]] ? 0 : 1;
      }
    });
  }
  (void)some_points();
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == 0);
}

TEST_CASE("a store of nothing holds nothing") {
  test::TestJob test;
  VertexStore store(test.job, 1 << 20);
  store.begin_keeping(false);
  store.finish_keeping();
  CHECK(store.size() == 0);
  const auto batch = std::make_unique<FaceBatch>();
  CHECK_NOTHROW(store.gather({nullptr, nullptr, nullptr}, {0, 0}, 0, *batch));
}

}  // namespace winnow
