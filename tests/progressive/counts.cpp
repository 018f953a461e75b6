// Any count can be extracted, up and down, step by step, and from no more bytes than are told.
#include <winnow/error.hpp>

#include "support/job.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"
#include "support/random.hpp"

namespace winnow::test {

TEST_CASE("every count is met by one collapse less at the most", "[progressive][long]") {
  ProgressivePlace place;
  const std::string file = place.made(mountains());
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t wanted =
        random.between(place.report.output.base_faces, place.report.output.faces);
    const std::string level = place.extracted(file, Target::faces(wanted));
    const std::uint64_t got = place.extract_report.output.faces;
    CAPTURE(wanted, got);
    CHECK(got <= wanted);
    CHECK(got + 2 > wanted);
    CHECK(welded_input(place.context, level).face_count() == got);
  }
  CHECK(error_of([&] { place.extracted(file, Target::faces(5)); }).kind() == ErrorKind::usage);
}

TEST_CASE("a count shows the same mesh from above and from below", "[progressive][long]") {
  ProgressivePlace place;
  const std::string file = place.made(whale());
  ProgressiveMesh levels(place.context, file);
  ProgressiveMesh other(place.context, file);
  Random random(7);
  for (int i = 0; i < 12; ++i) {
    const std::uint64_t high = random.between(levels.base_face_count(), levels.full_face_count());
    const std::uint64_t low = random.between(levels.base_face_count(), high);
    levels.go_to(high);
    levels.go_to(low);
    other.go_to(levels.base_face_count());
    other.go_to(low);
    CHECK(levels.face_count() == other.face_count());
    const bool same = faces_by_content(levels.mesh()) == faces_by_content(other.mesh());
    CHECK(same);
  }
}

TEST_CASE("steps lead to the base and back to all faces", "[progressive]") {
  ProgressivePlace place;
  ProgressiveOptions options;
  options.base = 50;
  const std::string file = place.made(mountains(), options);
  ProgressiveMesh levels(place.context, file);
  CHECK_FALSE(levels.step_back());
  std::uint64_t steps = 0;
  while (levels.step_forward()) ++steps;
  CHECK(levels.face_count() == levels.full_face_count());
  const auto all = faces_by_content(levels.mesh());
  CHECK(steps > levels.full_face_count() / 3);
  std::uint64_t back = 0;
  while (levels.step_back()) ++back;
  CHECK(back == steps);
  CHECK(levels.face_count() == levels.base_face_count());
  levels.go_to(levels.full_face_count());
  const bool same = faces_by_content(levels.mesh()) == all;
  CHECK(same);
}

TEST_CASE("a prefix of the file is enough for the count that the header tells", "[progressive]") {
  ProgressivePlace place;
  place.raw = true;
  const std::string file = place.made(whale());
  const std::string bytes = bytes_of_file(file);
  const ProgressiveInfo told = progressive_info(place.context, file);
  CHECK(told.bytes == bytes.size());
  REQUIRE(told.prefixes.size() >= 3);
  for (const ProgressiveInfo::Prefix& prefix : told.prefixes) {
    const std::string whole = bytes_of_file(place.extracted(file, Target::faces(prefix.faces)));
    const std::string cut = place.directory.file("cut.wpm");
    write_file(cut, bytes.substr(0, prefix.bytes));
    const std::string level = place.extracted(cut, Target::faces(prefix.faces), "cut.ply");
    CHECK(bytes_of_file(level) == whole);
    if (prefix.bytes == bytes.size()) continue;
    const Error error = error_of([&] { place.extracted(cut, Target::ratio(1), "never.ply"); });
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK_THAT(error.what(), Catch::Contains("cut short"));
    CHECK_FALSE(progressive_info(place.context, cut).notes.empty());
  }
  write_file(place.directory.file("head.wpm"), bytes.substr(0, 100));
  CHECK(error_of([&] {
          progressive_info(place.context, place.directory.file("head.wpm"));
        }).kind() == ErrorKind::bad_input);
}

}  // namespace winnow::test
