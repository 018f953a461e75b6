// OBJ, OFF and .m that are wrong, cut or hostile: an error that says where, or a shorter mesh,
// never worse.
#include "base/text.hpp"
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"
#include "support/text_meshes.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

// The error, or the number of faces.
struct Outcome {
  std::string error;
  std::size_t faces = 0;
};

Outcome outcome_of(const std::string& file, Format format, bool pipe) {
  try {
    test::TestJob test({.memory = std::uint64_t{64} << 20});
    const auto kind = pipe ? test::MemorySource::Kind::pipe : test::MemorySource::Kind::file;
    return {"", test::faces_of(test.job, std::make_unique<test::MemorySource>(file, kind),
                               {format, Access::once, {std::uint64_t{8} << 20, 1024}})
                    .size()};
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::bad_input);
    return {error.what(), 0};
  }
}

void check_line(const std::string& file, std::uint64_t line) {
  for (const bool pipe : {false, true}) {
    const std::string error = outcome_of(file, Format::automatic, pipe).error;
    CAPTURE(file.substr(0, 200), error);
    CHECK(error.find("line " + grouped(line) + ":") != std::string::npos);
  }
}

std::vector<std::pair<Format, std::string>> small_files() {
  test::Random random(440);
  const test::Polygons mesh = test::as_floats(test::random_polygons(random, 6, 5, 4));
  return {
      {Format::obj, obj_file(mesh, {})}, {Format::obj, obj_file(mesh, {"\r\n", &random})},
      {Format::off, off_file(mesh, {})}, {Format::off, off_file(mesh, {"\r\n", &random}, "COFF")},
      {Format::m, m_file(mesh, {})},     {Format::m, m_file(mesh, {"\r\n", &random})}};
}

}  // namespace

TEST_CASE("what is no number in a mesh as text is refused with its line") {
  check_line("v 0 0 0\nv 1 0 x\nv 0 1 0\n", 2);
  check_line("v 0 0 0\nv 1 0\nv 0 1 0\n", 2);
  check_line("v 0 0 0\n\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", 5);
  check_line("v 0 0 0\r\n\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3,\r\n", 5);
  check_line("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 /3\r", 4);
  check_line("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n", 5);
  check_line("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n\n3 0 1\n", 7);
  check_line("OFF\n3 -1 0\n0 0 0\n", 2);
  check_line("OFF\n3 x\n0 0 0\n", 2);
  check_line("Vertex 1 0 0 0\nVertex x 0 0 1\n", 2);
  check_line("Vertex 1 0 0 0\nVertex 4294967295 0 0 1\n", 2);
  check_line("Vertex 1 0 0 0\nFace 1 1 a 2\n", 2);
  std::string far;
  for (int i = 0; i < 5000; ++i) far += "v 1 2 3\n";
  check_line(far + "v a\nv b\n" + far + "v c\n", 5001);
}

TEST_CASE("a mesh as text cut at every byte is an error or a mesh of fewer faces") {
  for (const auto& [format, file] : small_files()) {
    const std::size_t whole = outcome_of(file, format, false).faces;
    REQUIRE(whole >= 5);
    for (std::size_t length = 0; length < file.size(); ++length) {
      CAPTURE(file, length);
      const Outcome cut = outcome_of(file.substr(0, length), format, false);
      CHECK(outcome_of(file.substr(0, length), format, true).faces == cut.faces);
      CHECK(cut.faces <= whole);
      // An OFF says how much there is; only what stands behind the last index may miss.
      if (format == Format::off && cut.error.empty()) CHECK(cut.faces == whole);
    }
  }
}

TEST_CASE("an OFF whose counts its size cannot hold is refused before anything is taken for it") {
  for (const char* counts :
       {"1000 1 0", "3 1000 0", "4294967295 1 0", "3 18446744073709551615 0",
        "9223372036854775807 9223372036854775807 0", "4294967296 4294967296 0"}) {
    const std::string file = std::string("OFF\n") + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const bool pipe : {false, true}) {
      const std::uint64_t peak = peak_resident_bytes();
      CAPTURE(counts, pipe);
      CHECK(outcome_of(file, Format::automatic, pipe).error != "");
      if (!test::sanitized) CHECK(peak_resident_bytes() - peak < std::uint64_t{32} << 20);
    }
  }
}

TEST_CASE("a long line is read, whatever it is long by") {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const bool pipe : {false, true}) {
    const auto faces = [&](const std::string& lines) {
      return outcome_of(head + lines, Format::automatic, pipe).faces;
    };
    CHECK(faces("f" + std::string(2'000'000, ' ') + "1 2 3\n") == 2);
    CHECK(faces("#" + std::string(2'000'000, 'x') + "\nf 1 2 3") == 2);
    CHECK(faces("g" + std::string(2'000'000, '\\') + "\r\nf 1 2 3\r\n") == 2);
    std::string joined = "f";
    for (int i = 0; i < 300'000; ++i) joined += " \\\n";
    CHECK(faces(joined + "1 2 3\nf 2 1 3\n") == 3);
    std::string large = "f";
    for (int i = 0; i < 50'000; ++i) large += " " + std::to_string(i % 3 + 1);
    CHECK(faces(large) == 49'999);
    // What is wrong behind a long line has its number.
    CHECK(outcome_of(head + "#" + std::string(2'000'000, ' ') + "\nf 1 x 2\n", Format::automatic,
                     pipe)
              .error.find("line 6:") != std::string::npos);
  }
}

TEST_CASE("bytes of a mesh as text changed at random are an error or another mesh, nothing worse") {
  test::Random random(441);
  for (int round = 0; round < 1500; ++round) {
    auto [format, file] = random.one_of(small_files());
    for (std::uint64_t changes = random.between(1, 6); changes > 0 && !file.empty(); --changes) {
      const std::size_t at = random.below(file.size());
      const std::string bytes =
          random.one_of<std::string>({"9", "-", "\n", " ", "\xff", std::string(1, '\0'), "\\\n",
                                      "#", "99999", "e", "\r", "/", "v ", "f "});
      if (random.chance(0.3)) {
        file.erase(at, random.between(1, 9));
      } else if (random.chance(0.5)) {
        file.insert(at, bytes);
      } else {
        file.replace(at, bytes.size(), bytes);
      }
    }
    CAPTURE(round, file);
    const Outcome outcome = outcome_of(file, format, false);
    REQUIRE(outcome_of(file, format, true).faces == outcome.faces);
    REQUIRE(outcome.faces < 200);
  }
}

}  // namespace winnow
