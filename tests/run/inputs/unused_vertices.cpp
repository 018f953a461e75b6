// Vertices that no face uses, however far off, change neither boxes nor percentages nor cells.
#include "support/ply_file.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

// The mesh alone, and with vertices that nothing uses.
struct Files {
  Directory directory;
  std::string plain = directory.file("plain.ply"), loose = directory.file("loose.ply");

  explicit Files(std::size_t side) {
    Random random(9);
    Polygons mesh;
    for (std::size_t i = 0; i < side * side; ++i) {
      const std::size_t row = i / side, column = i % side;
      mesh.vertices.push_back(
          {static_cast<double>(column), static_cast<double>(row), random.real(0, 2)});
      if (row == 0 || column == 0) continue;
      const auto here = static_cast<std::int64_t>(i), below = static_cast<std::int64_t>(i - side);
      mesh.faces.push_back({below - 1, below, here});
      mesh.faces.push_back({below - 1, here, here - 1});
    }
    write_file(plain, ply_file(mesh, {}));
    mesh.vertices.push_back({1e6, -1e6, 1e6});
    mesh.vertices.push_back({-3e6, 0, 0});
    mesh.vertices.push_back({0, 0, -1e5});
    write_file(loose, ply_file(mesh, {}));
  }

  void check(const Words& options) {
    INFO(joined(options));
    const Simplified right = simplified(directory, plain, options);
    const Simplified out = simplified(directory, loose, options + Words{"--threads", "3"});
    CHECK(out.hash == right.hash);
    CHECK(out.report["cell_size"] == right.report["cell_size"]);
    CHECK(out.report["output"]["faces"] > 3);
    CHECK(simplified_by_pipe(directory, loose, options).hash == right.hash);
    const std::string smallest = smallest_memory(loose, options);
    CHECK(simplified(directory, loose, options + Words{"--memory", smallest}).hash == right.hash);
  }
};

}  // namespace

TEST_CASE("unused vertices change no grid and no percentage") {
  Files files(60);
  files.check({"--grid", "25"});
  // Where all faces are refined, vertices may come in another order.
  const Words error{"--error", "0.5%"};
  const double right = simplified(files.directory, files.plain, error).report["output"]["faces"];
  const double out = simplified(files.directory, files.loose, error).report["output"]["faces"];
  CHECK(out == Approx(right).epsilon(0.05));
  const Words weld{"--faces", "500", "--weld", "0.01%"};
  CHECK(simplified(files.directory, files.loose, weld).report["weld"] ==
        simplified(files.directory, files.plain, weld).report["weld"]);
}

TEST_CASE("unused vertices change no cell that is found for a count") {
  Files files(60);
  files.check({"--faces", "500", "--refine", "none"});
  files.check({"--ratio", "10%", "--detail", "4"});
  // Too few for a sample to tell what is far.
  Files few(8);
  few.check({"--faces", "40", "--refine", "none"});
  few.check({"--grid", "5"});
}

}  // namespace winnow::test
