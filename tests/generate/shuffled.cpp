// --shuffle changes the order of the faces and nothing else.
#include "surface_mesh.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// The records of `size` bytes that follow the first `skipped`.
std::vector<std::string> records(const std::string& bytes, std::size_t skipped, std::size_t size) {
  std::vector<std::string> all;
  for (std::size_t at = skipped; at + size <= bytes.size(); at += size)
    all.push_back(bytes.substr(at, size));
  return all;
}

void check_shuffled(const std::string& plain, const std::string& shuffled, std::size_t skipped,
                    std::size_t size) {
  REQUIRE(plain.size() == shuffled.size());
  CHECK(plain.substr(0, skipped) == shuffled.substr(0, skipped));
  auto one = records(plain, skipped, size);
  auto other = records(shuffled, skipped, size);
  CHECK(one != other);
  std::sort(one.begin(), one.end());
  std::sort(other.begin(), other.end());
  CHECK(one == other);
}

}  // namespace

TEST_CASE("shuffled faces are the same faces in another order") {
  for (const Surface surface : all_surfaces) {
    CAPTURE(static_cast<int>(surface));
    GenerateOptions options = generate_options(surface, 50000);
    const std::string ply = generated(options, Format::ply);
    const std::string stl = generated(options, Format::stl);
    const std::uint64_t faces = make_surface(options)->faces();
    options.shuffle = true;
    check_shuffled(ply, generated(options, Format::ply), ply.size() - 13 * faces, 13);
    check_shuffled(stl, generated(options, Format::stl), 84, 50);
  }
}

}  // namespace winnow
