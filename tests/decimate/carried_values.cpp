// What the vertex of a collapsed edge carries lies between what its ends carried.
#include "decimate/carried_values.hpp"

#include "support/random.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

const std::vector<Attribute> one(1);
const std::vector<Attribute> two(2);

}  // namespace

TEST_CASE("a collapsed edge's values lie between those of its ends") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto point = [&] {
      return Point{random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)};
    };
    const std::vector<Point> ends{point(), i % 10 == 0 ? Point{} : point()};
    const std::vector<double> numbers{random.real(-9, 9), 5, random.real(-9, 9), 5};
    CarriedValues values(two, ends, numbers);
    values.collapsed({1, 0, point()});
    const auto [low, high] = std::minmax(numbers[0], numbers[2]);
    REQUIRE(values.of(1)[0] >= low);
    REQUIRE(values.of(1)[0] <= high);
    REQUIRE(values.of(1)[1] == 5);
    REQUIRE(values.of(0)[0] == numbers[0]);
  }
}

TEST_CASE("values follow the place that a vertex goes to") {
  const auto after = [](double x) {
    CarriedValues values(one, {Point{0, 0, 0}, Point{1, 0, 0}}, {0, 8});
    values.collapsed({0, 1, {x, 3, 0}});
    // The next collapse finds the vertex where it went.
    return values.of(0)[0];
  };
  CHECK(after(0.5) == 4);
  CHECK(after(0) == after(-7));
  CHECK(after(1) == after(7));
  CHECK(after(0) + after(1) == 8);
  CHECK(after(0.25) < after(0.5));
  CHECK(after(0.25) > after(0));
}

TEST_CASE("an edge without a length gives the mean of its ends") {
  CarriedValues values(one, {Point{1, 1, 1}, Point{1, 1, 1}}, {2, 4});
  values.collapsed({0, 1, {5, 5, 5}});
  CHECK(values.of(0)[0] == 3);
}

TEST_CASE("a collapse into a hub of another tile changes nothing") {
  CarriedValues values(one, {Point{0, 0, 0}, Point{1, 0, 0}}, {2, 4});
  values.collapsed({7, 1, {3, 0, 0}});
  CHECK(values.of(0)[0] == 2);
  CHECK(values.of(1)[0] == 4);
}

TEST_CASE("nothing is carried where there is nothing to carry") {
  CarriedValues values;
  values.collapsed({0, 1, {}});
  CHECK(values.of(7).empty());
}

TEST_CASE("of two labels the nearer one stays, and of two values the one that is there") {
  std::vector<Attribute> attributes(2);
  attributes[0].kind = AttributeKind::label;
  attributes[1].no_data = -9999;
  const auto after = [&](double x, const std::vector<double>& numbers) {
    CarriedValues values(attributes, {Point{0, 0, 0}, Point{1, 0, 0}}, numbers);
    values.collapsed({0, 1, {x, 3, 0}});
    return std::vector<double>(values.of(0).begin(), values.of(0).end());
  };
  using Values = std::vector<double>;
  CHECK(after(0.2, {7, -9999, 3, 5}) == Values{7, 5});
  CHECK(after(0.8, {7, 5, 3, -9999}) == Values{3, 5});
  CHECK(after(0.5, {7, -9999, 3, -9999}) == Values{3, -9999});
  CHECK(after(0.5, {3, 1, 7, 3}) == Values{3, 2});
}

}  // namespace winnow::test
