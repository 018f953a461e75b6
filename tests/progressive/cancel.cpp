// Making and extracting stop within a second, and leave nothing behind.
#include <winnow/error.hpp>

#include "support/job.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"

#include <chrono>

namespace winnow::test {

TEST_CASE("making a progressive file can be cancelled at any time", "[progressive]") {
  ProgressivePlace place;
  generate("scan", 1'000'000, place.directory.file("scan.ply"));
  const std::size_t before = place.directory.names().size();
  for (const int wait : {50, 400, 1500, 2500}) {
    const auto thread = cancel_later(place.context, std::chrono::milliseconds(wait));
    try {
      place.made(place.directory.file("scan.ply"));
      return;  // it was faster
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::cancelled);
    }
    CHECK(place.directory.names().size() == before);
    place.context.reset();
  }
}

}  // namespace winnow::test
