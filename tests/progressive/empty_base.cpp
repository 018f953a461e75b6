// A file whose coarsest mesh is empty is no progressive mesh: nothing could be split in it.
#include "progressive/file_header.hpp"
#include "support/progressive.hpp"

#include <cstring>

#include <catch2/catch.hpp>

namespace winnow::test {

TEST_CASE("a progressive file without a coarsest mesh is damaged", "[progressive]") {
  ProgressivePlace place;
  const std::string file = place.made(mountains(), {});
  std::string bytes = bytes_of_file(file);
  std::uint32_t size = 0;
  std::memcpy(&size, &bytes[12], 4);
  constexpr std::size_t checksum_at = 16, base_chunks_at = 120;
  std::memset(&bytes[checksum_at], 0, 4);
  std::memset(&bytes[base_chunks_at], 0, 4);
  const std::uint32_t checksum = checksum_of(std::as_bytes(std::span(bytes).first(size)));
  std::memcpy(&bytes[checksum_at], &checksum, 4);
  write_file(file, bytes);
  for (const std::uint64_t faces : {4U, 96U, 5000U})
    CHECK_THROWS_WITH(place.extracted(file, Target::faces(faces)),
                      Catch::Contains("is damaged: its coarsest mesh is empty"));
}

}  // namespace winnow::test
