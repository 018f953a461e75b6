// Colours of some vertices of an OBJ are left out and named, whatever the order of the vertices.
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

Carried carried_by_lines(const std::vector<std::string>& vertices) {
  std::string file;
  for (const std::string& vertex : vertices) file += "v " + vertex + "\n";
  file += "f 1 2 3\nf 1 3 4\n";
  return carried_by(std::make_unique<MemorySource>(file));
}

}  // namespace

TEST_CASE("colours that some vertices lack are carried by none, in any order") {
  std::vector<std::string> vertices{"0 0 0 1 0 0", "1 0 0", "1 1 0 0 1 0", "0 1 0 0 0 1"};
  std::sort(vertices.begin(), vertices.end());
  do {
    const Carried carried = carried_by_lines(vertices);
    CHECK(carried.attributes.empty());
    CHECK(carried.numbers.empty());
    CHECK(carried.facts.offer.scalars.empty());
    CHECK(carried.facts.offer.unread == std::vector<std::string>{"colours of some vertices"});
  } while (std::next_permutation(vertices.begin(), vertices.end()));
}

TEST_CASE("colours that all vertices have are carried") {
  const Carried carried =
      carried_by_lines({"0 0 0 1 0 0", "1 0 0 1 1 0", "1 1 0 0 1 0", "0 1 0 0 0 1"});
  CHECK(carried.attributes.size() == 3);
  CHECK(carried.facts.offer.unread.empty());
}

}  // namespace winnow::test
