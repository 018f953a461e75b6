// What is refused is refused before anything is written.
#include <winnow/error.hpp>

#include "surface_mesh.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

void check_refused(const GenerateOptions& options, const std::string& name, ErrorKind kind,
                   std::uint64_t memory = std::uint64_t{64} << 20) {
  const test::Directory directory;
  Context context;
  context.memory = memory;
  bool refused = false;
  try {
    generate(context, directory.file(name), options);
  } catch (const Error& error) {
    refused = error.kind() == kind;
    INFO(error.what());
    CHECK(refused);
  }
  CHECK(refused);
  CHECK(directory.names().empty());
}

}  // namespace

TEST_CASE("counts that make no sense are refused") {
  for (const Surface surface : all_surfaces) {
    check_refused(generate_options(surface, 0), "mesh.ply", ErrorKind::usage);
    check_refused(generate_options(surface, 7), "mesh.ply", ErrorKind::usage);
    check_refused(generate_options(surface, UINT64_MAX), "mesh.stl", ErrorKind::usage);
  }
}

TEST_CASE("more vertices than PLY can count are refused") {
  for (const Surface surface : all_surfaces) {
    check_refused(generate_options(surface, 10'000'000'000), "mesh.ply", ErrorKind::usage);
  }
}

TEST_CASE("an offset that is not finite is refused") {
  GenerateOptions options = generate_options(Surface::scan, 1000);
  options.offset[1] = std::numeric_limits<double>::infinity();
  check_refused(options, "mesh.ply", ErrorKind::usage);
  options.offset[1] = std::numeric_limits<double>::quiet_NaN();
  check_refused(options, "mesh.ply", ErrorKind::usage);
}

TEST_CASE("a budget too small for one block is refused") {
  check_refused(generate_options(Surface::scan, 1000), "mesh.ply", ErrorKind::resources, 1000);
}

}  // namespace winnow
