// Several meshes of one call: those that go to files, from arrays and in batches.
#include "support/levels.hpp"

#include <winnow/error.hpp>
#include <winnow/mesh.hpp>
#include <winnow/simplification.hpp>

#include "support/job.hpp"
#include "support/mesh_arrays.hpp"
#include "support/program.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

TEST_CASE("several meshes in memory are those of the files") {
  const Directory directory;
  Context context;
  context.scratch = directory.path();
  generate("scan", 20'000, directory.file("in.ply"));
  const SimplifyOptions options =
      to_levels({Target::faces(4000), Target::faces(1000), Target::faces(100)});
  const SimplifyReport report =
      simplify(context, directory.file("in.ply"), directory.file("level-{faces}.ply"), options);
  SimplifyReport told;
  const std::vector<Mesh> meshes =
      simplify_levels(context, directory.file("in.ply"), options, &told);
  REQUIRE(meshes.size() == 3);
  REQUIRE(told.levels.size() == 3);
  for (std::size_t level = 0; level < 3; ++level) {
    CHECK(meshes[level].face_count() == report.levels[level].output.faces);
    CHECK(told.levels[level].output.faces == report.levels[level].output.faces);
    const std::string file = directory.file("again.ply");
    write_file(file, ply_of_arrays(meshes[level]));
    const SimplifyOptions all = to_levels({Target::faces(1'000'000)});
    CHECK(simplify(context, file, all).faces ==
          simplify(context, report.levels[level].output.name, all).faces);
  }
  const Mesh& finest = meshes.front();
  Simplification batches(context, to_levels({Target::faces(2000), Target::faces(500)}));
  batches.add_vertices(std::get<std::vector<float>>(finest.positions));
  batches.add_faces(finest.faces);
  const std::vector<Mesh> made = batches.finish_meshes();
  REQUIRE(made.size() == 2);
  CHECK(made[0].face_count() == 2000);
  CHECK(made[1].face_count() == 500);
}

TEST_CASE("several targets where one mesh is given, or that do not get coarser, are refused") {
  Context context;
  const auto refused = [&](const SimplifyOptions& options, const char* part) {
    const Error error = error_of([&] { simplify(context, "missing.ply", options); });
    CHECK(error.kind() == ErrorKind::usage);
    INFO(error.what());
    CHECK(std::string(error.what()).find(part) != std::string::npos);
  };
  refused(to_levels({Target::faces(100), Target::faces(10)}), "simplify_levels()");
  const auto contradict = [&](const std::vector<Target>& targets, const char* part) {
    const Error error =
        error_of([&] { simplify_levels(context, "missing.ply", to_levels(targets)); });
    INFO(error.what());
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find(part) != std::string::npos);
  };
  contradict({Target::faces(10), Target::faces(100)}, "coarser than the one before");
  contradict({Target::faces(10), Target::ratio(0.1)}, "of one kind");
  contradict({Target::cell(1), Target::cell(2)}, "made by refining");
  contradict({Target::error(0.1), Target::error(Distance::of_diagonal(0.1))}, "all lengths");
}

}  // namespace winnow::test
