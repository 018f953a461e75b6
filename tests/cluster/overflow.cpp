// Sums that are too large for 64 bits are the sums all the same.
#include "base/parallel.hpp"
#include "base/wide.hpp"
#include "cluster/cell_table.hpp"
#include "cluster/representative.hpp"
#include "io/arena.hpp"
#include "support/clustering.hpp"
#include "support/kernels.hpp"

#include <map>

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

// One entry for each corner, added up in 128 bits.
std::map<CellKey, WholeCell> wide_sums(const std::vector<Triangle>& faces, const Grid& grid) {
  std::map<CellKey, WholeCell> cells;
  for (std::size_t from = 0; from < faces.size(); from += kernel_capacity) {
    const std::size_t count = std::min(kernel_capacity, faces.size() - from);
    const std::vector<Triangle> part(faces.begin() + static_cast<std::ptrdiff_t>(from),
                                     faces.begin() + static_cast<std::ptrdiff_t>(from + count));
    const auto sums = kernel_sums(corner_kernel_baseline, part, grid);
    for (std::size_t i = 0; i < count; ++i) {
      REQUIRE(sums->kind[i] <= three_cells);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        QuadricCellSum one{};
        one.key = morton_key(static_cast<PackedCell>(sums->cell[corner][i]));
        const std::int64_t weight = sums->weight[corner][i];
        one.weight = static_cast<std::uint64_t>(weight);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          one.position[axis] = weight * (sums->place[corner][axis][i] & ((1 << fraction_bits) - 1));
          one.normal[axis] = weight * sums->normal[axis][i];
          one.moment[axis] = weight * sums->moment[corner][axis][i];
        }
        for (std::size_t k = 0; k < 5; ++k) one.squares[k] = weight * sums->squares[k][i];
        cells.try_emplace(one.key, one.key, nullptr).first->second.add(one);
      }
    }
  }
  return cells;
}

struct Sums {
  Int128 weight = 0;
  std::array<Int128, 3> position{}, normal{};
  bool used = false;
  friend bool operator==(const Sums&, const Sums&) = default;

  void add(const CellSum& sum) {
    weight += static_cast<Int128>(sum.weight & ~CellSum::used_bit);
    used = used || (sum.weight & CellSum::used_bit) != 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position[axis] += sum.position[axis];
      normal[axis] += sum.normal[axis];
    }
  }
};

// Anything from one unit to as much as an entry can hold, with numbers as large as such a weight
// allows.
CellSum random_sum(Random& random, CellKey key) {
  CellSum sum{};
  sum.key = key;
  const std::uint64_t weight =
      random.chance(0.3) ? CellSum::weight_bound - random.between(1, 3)
                         : random.between(1, CellSum::weight_bound - 1) >> random.below(40);
  sum.weight = std::max<std::uint64_t>(1, weight);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto w = static_cast<std::int64_t>(sum.weight);
    sum.position[axis] =
        w * (random.chance(0.3) ? (1 << fraction_bits) - 1
                                : static_cast<std::int64_t>(random.below(1 << fraction_bits)));
    sum.normal[axis] =
        w * random.one_of<std::int64_t>({-(1 << normal_bits) - 1, (1 << normal_bits) + 1, 5});
  }
  if (random.chance(0.2)) sum.weight |= CellSum::used_bit;
  return sum;
}

}  // namespace

TEST_CASE("one face of a million cells beside a million faces in one cell", "[long]") {
  Random random(450);
  const Grid grid = unit_grid();
  // Half a cell area each: together far beyond what one entry holds.
  std::vector<Triangle> faces;
  for (int i = 0; i < 1'000'000; ++i) {
    Triangle face{Point{5.01, 7.01, 9}, Point{5.99, 7.01, 9}, Point{5.5, 7.99, 9}};
    for (Point& corner : face) corner[2] += random.real(0.1, 0.9);
    faces.push_back(random.chance(0.7) ? face : turned(face));
  }
  faces.insert(faces.begin() + 500'000,
               {Point{5.3, 7.4, 9.2}, Point{1'000'005.5, 7, 9}, Point{6, 1'000'007, 1'000'000}});
  faces.push_back({Point{5.2, 7.2, 9.9}, Point{1'000'005.5, 7, 9}, Point{6, 1'000'007, 1'000'000}});
  const std::map<CellKey, WholeCell> right = wide_sums(faces, grid);

  for (const Placement placement : {Placement::mean, Placement::quadric}) {
    const ClusterSettings settings{grid, placement, true};
    for (const unsigned threads : {1U, 3U}) {
      const PlainMesh mesh = cluster(faces, settings, {.threads = threads, .batches = &random});
      CAPTURE(static_cast<int>(placement), threads);
      CHECK(mesh.cells == right.size());
      REQUIRE(mesh.vertices.size() == 3);
      CHECK(mesh.faces.size() == 1);
      CHECK(mesh.counts.clamped == 2);
      for (const IndexedVertex& vertex : mesh.vertices) {
        const IndexedVertex exact = right.at(vertex.key).vertex(settings);
        CHECK(vertex.position == exact.position);
        CHECK(vertex.normal == exact.normal);
      }
      random.shuffle(faces);
    }
  }
}

TEST_CASE("entries near the bound add up exactly in any order", "[threads]") {
  Random random(451);
  for (int round = 0; round < 40; ++round) {
    std::vector<CellSum> entries(random.between(1, 3000));
    std::map<CellKey, Sums> right;
    const std::uint64_t keys = random.one_of<std::uint64_t>({1, 5, 100, 100'000});
    for (CellSum& entry : entries) {
      entry = random_sum(random, random.below(keys));
      right[entry.key].add(entry);
    }
    for (const unsigned threads : {1U, 3U}) {
      random.shuffle(entries);
      TestJob here({.threads = threads});
      // The small table spills.
      CellTable<CellSum> table(here.job, random.chance(0.5) ? 1 << 18 : 1 << 24,
                               random.one_of<std::size_t>({1, 4}));
      in_arena(here.job, [&] {
        std::vector<std::vector<CellSum>> batches;
        std::size_t at = 0;
        for (const std::size_t size : random.parts(entries.size(), 200)) {
          batches.emplace_back(entries.begin() + static_cast<std::ptrdiff_t>(at),
                               entries.begin() + static_cast<std::ptrdiff_t>(at + size));
          at += size;
        }
        parallel_for(batches.size(), [&](std::size_t i) { table.add(batches[i]); });
      });
      std::map<CellKey, Sums> got;
      CellKey last = 0;
      const auto cursor = table.finish();
      for (CellSum sum; cursor->next(sum);) {
        REQUIRE(sum.key >= last);
        REQUIRE((sum.weight & ~CellSum::used_bit) < CellSum::weight_bound);
        last = sum.key;
        got[sum.key].add(sum);
      }
      CAPTURE(round, threads);
      REQUIRE(got == right);
    }
  }
}

TEST_CASE("a bounded weight bounds every sum") {
  // The largest numbers that a corner can bring, as often as the weight allows.
  const Int128 weight = CellSum::weight_bound - 1;
  constexpr Int128 largest = INT64_MAX;
  CHECK(weight * ((1 << fraction_bits) - 1) <= largest);
  CHECK(weight * ((1 << normal_bits) + 1) <= largest);
  CellSum a{};
  a.weight = CellSum::weight_bound / 2;
  CellSum b = a;
  CHECK_FALSE(CellSum::combine(a, b));
  CHECK(a.weight == CellSum::weight_bound / 2);
  b.weight = (CellSum::weight_bound / 2 - 1) | CellSum::used_bit;
  CHECK(CellSum::combine(a, b));
  CHECK(a.weight == ((CellSum::weight_bound - 1) | CellSum::used_bit));
}

TEST_CASE("a face counted more often than 32 bits hold keeps every count") {
  CellFace a{{1, 2, 3}, UINT32_MAX - 1, 5};
  CHECK(CellFace::combine(a, {{1, 2, 3}, 1, 5}));
  CHECK(a.along == UINT32_MAX);
  CHECK_FALSE(CellFace::combine(a, {{1, 2, 3}, 1, 0}));
  CHECK(a.along == UINT32_MAX);
  CHECK(a.against == 10);
}

}  // namespace winnow
