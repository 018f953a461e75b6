// Several results of one run: each as exact as one of its own, the finest the same to the bit.
#include <winnow/compare.hpp>

#include "support/levels.hpp"
#include "support/program.hpp"
#include "support/refined_file.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

struct Place {
  Directory directory;
  Context context;

  Place() {
    context.threads = 2;
    context.scratch = directory.path();
  }

  [[nodiscard]] std::string name(const std::string& kind) const {
    return directory.file("level-{" + kind + "}.ply");
  }

  double rms(const std::string& original, const std::string& simplified) {
    CompareOptions options;
    options.samples = 200'000;
    return compare(context, original, simplified, options).symmetric.rms;
  }
};

}  // namespace

TEST_CASE("each of several counts is met, and the finest is what it is alone", "[long]") {
  Place place;
  for (const Refine cost : {Refine::quadric, Refine::volume, Refine::importance}) {
    SimplifyOptions options =
        to_levels({Target::faces(30'000), Target::faces(9'001), Target::faces(500)});
    options.refine = cost;
    const SimplifyReport report =
        simplify(place.context, mountains(), place.name("faces"), options);
    REQUIRE(report.levels.size() == 3);
    CHECK(report.output.name == place.directory.file("level-30000.ply"));
    for (std::size_t level = 0; level < 3; ++level) {
      const LevelReport& told = report.levels[level];
      const std::uint64_t wanted = *level_of(options, level).target.faces();
      CAPTURE(wanted);
      CHECK(told.target_faces == wanted);
      CHECK(told.target_met == true);
      CHECK(told.refine.stopped_by == StoppedBy::count);
      CHECK(told.output.faces <= wanted);
      CHECK(told.output.faces + 1 >= wanted);
      TestJob test;
      const PlainMesh mesh = plain(welded(test.job, told.output.name));
      CHECK(mesh.faces.size() == told.output.faces);
      CHECK(mesh.vertices.size() == told.output.vertices);
      CHECK(defects_of(mesh.faces).crowded == 0);
    }
    const std::string alone = place.directory.file("alone.ply");
    simplify(place.context, mountains(), alone, level_of(options, 0));
    const std::string want = hash_of_file(alone);
    ::unlink(alone.c_str());
    CHECK(hashes_of_levels(report).front() == want);
  }
}

TEST_CASE("a level is as near to the surface as a result of a run of its own", "[long]") {
  Place place;
  SimplifyOptions options =
      to_levels({Target::ratio(0.3), Target::ratio(0.1), Target::ratio(0.03), Target::ratio(0.01)});
  const SimplifyReport report = simplify(place.context, whale(), place.name("ratio"), options);
  const std::string alone = place.directory.file("alone.ply");
  for (std::size_t level = 0; level < 4; ++level) {
    const LevelReport& told = report.levels[level];
    simplify(place.context, whale(), alone, level_of(options, level));
    CAPTURE(level, told.output.name);
    CHECK(place.rms(whale(), told.output.name) <= 1.05 * place.rms(whale(), alone));
    ::unlink(alone.c_str());
  }
}

TEST_CASE("each of several errors bounds the distance, and each level has fewer faces", "[long]") {
  Place place;
  SimplifyOptions options = to_levels({Target::error(Distance::of_diagonal(0.0005)),
                                       Target::error(Distance::of_diagonal(0.002)),
                                       Target::error(Distance::of_diagonal(0.01))});
  const SimplifyReport report = simplify(place.context, whale(), place.name("error"), options);
  REQUIRE(report.levels.size() == 3);
  CHECK(report.levels[1].output.name == place.directory.file("level-0.2%.ply"));
  CompareOptions few;
  few.samples = 1000;
  const double diagonal = compare(place.context, whale(), report.output.name, few).diagonal;
  std::uint64_t before = 100'000;
  for (std::size_t level = 0; level < 3; ++level) {
    const LevelReport& told = report.levels[level];
    const Distance error = *level_of(options, level).target.error();
    CAPTURE(level);
    CHECK(told.output.faces < before);
    before = told.output.faces;
    CHECK(place.rms(whale(), told.output.name) <= error.length(diagonal));
  }
}

TEST_CASE("a level goes on where the one before could not meet its count") {
  Place place;
  // Handles keep the skull from having so few faces.
  const SimplifyReport report =
      simplify(place.context, whale(), place.name("faces"),
               to_levels({Target::faces(1000), Target::faces(20), Target::faces(4)}));
  REQUIRE(report.levels.size() == 3);
  CHECK(report.levels[0].target_met == true);
  CHECK(report.levels[0].missed_by.empty());
  CHECK(report.levels[2].target_met == false);
  CHECK(report.levels[2].missed_by == std::vector{StoppedBy::topology});
  CHECK(report.levels[2].output.faces > 4);
  CHECK(report.levels[2].output.faces <= report.levels[1].output.faces);
}

TEST_CASE("attributes, boundaries and clustering go with every level") {
  Place place;
  const std::string input = place.directory.file("in.ply");
  generate("terrain", 60'000, input);
  SimplifyOptions options =
      to_levels({Target::faces(8000), Target::faces(2000), Target::faces(400)});
  options.detail = 3;
  options.normals = true;
  const SimplifyReport report = simplify(place.context, input, place.name("faces"), options);
  CHECK(report.clustered.first);
  CHECK(report.cell_size > 0);
  for (const LevelReport& level : report.levels) {
    CHECK(level.target_met == true);
    CHECK(level.topology.output.boundary > 0);
    CHECK(level.topology.output.non_manifold == 0);
    CHECK(bytes_of_file(level.output.name).find("property float nz") != std::string::npos);
  }
}

}  // namespace winnow::test
