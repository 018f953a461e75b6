// Wrong and hostile files: an error that says where, quickly, and without taking memory for what is
// not there.
#include "io/arena.hpp"
#include "read/for_each_batch.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Kind = test::MemorySource::Kind;

struct Outcome {
  std::optional<Error> error;
  std::size_t largest_take = 0;
  double seconds = 0;
};

// All that can be asked of a file. Anything but an Error gets out.
Outcome try_everything(const std::string& file, Kind kind, Format format = Format::automatic) {
  test::TestJob test({.memory = std::uint64_t{64} << 20});
  auto owned = std::make_unique<test::MemorySource>(file, kind);
  const test::MemorySource& source = *owned;
  Outcome outcome;
  const Stopwatch watch;
  try {
    const auto reader = open_reader(test.job, std::move(owned), format, Access::once,
                                    {std::uint64_t{8} << 20, 1024});
    in_arena(test.job, [&] {
      if (reader->facts().vertices)
        for_each_position_batch(test.job, *reader, [](const PositionView&) {});
      reader->begin_faces();
      for_each_face_batch(test.job, *reader, [](const FaceBatch&) {}, {});
    });
    outcome.largest_take = source.largest_take();
  } catch (const Error& error) {
    outcome.error = error;
  }
  outcome.seconds = watch.seconds();
  return outcome;
}

void check_refused(const std::string& file) {
  for (const Kind kind : {Kind::file, Kind::pipe}) {
    const std::uint64_t peak = peak_resident_bytes();
    const Outcome outcome = try_everything(file, kind);
    CAPTURE(file.substr(0, 600), static_cast<int>(kind));
    REQUIRE(outcome.error);
    CAPTURE(outcome.error->what());
    CHECK(outcome.error->kind() == ErrorKind::bad_input);
    CHECK(std::string(outcome.error->what()).find('\n') == std::string::npos);
    CHECK(outcome.seconds < 5 * test::patience);
    if (!test::sanitized) CHECK(peak_resident_bytes() - peak < std::uint64_t{64} << 20);
  }
}

std::string header(const std::string& form, const std::string& elements) {
  return "ply\nformat " + form + " 1.0\n" + elements + "end_header\n";
}

const std::vector<std::string> forms{"ascii", "binary_little_endian", "binary_big_endian"};
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list uchar int vertex_indices\n";

}  // namespace

TEST_CASE("counts that the file cannot hold are refused") {
  for (const std::string& form : forms) {
    for (const char* count :
         {"1000", "4294967295", "4294967296", "281474976710655", "9223372036854775808",
          "18446744073709551615", "18446744073709551616", "-1", "1e9"}) {
      const std::string number = count;
      check_refused(
          header(form, "element vertex " + number + "\n" + xyz + "element face 1\n" + list) +
          std::string(100, '1'));
      check_refused(
          header(form, "element vertex 2\n" + xyz + "element face " + number + "\n" + list) +
          "0 0 0 1 1 1 " + std::string(12, '\1'));
      check_refused(header(form, "element other " + number +
                                     "\nproperty int a\nelement vertex 2\n" + xyz +
                                     "element face 1\n" + list) +
                    std::string(100, '1'));
      check_refused(header(form, "element other " + number +
                                     "\nproperty list uint double a\nelement vertex 2\n" + xyz +
                                     "element face 1\n" + list) +
                    std::string(100, '1'));
      check_refused(
          header(form, "element face " + number + "\n" + list + "element vertex 2\n" + xyz) +
          std::string(100, '1'));
    }
  }
}

TEST_CASE("a list longer than its file is refused") {
  for (const char* type : {"uchar", "ushort", "uint", "char", "int"}) {
    const std::string lists = std::string("property list ") + type + " int vertex_indices\n";
    const std::string full(4, '\x7f');  // a length of 127 or more by any type
    const std::string vertices(24, '\0');
    for (const std::string form : {"binary_little_endian", "binary_big_endian"}) {
      check_refused(header(form, "element vertex 2\n" + xyz + "element face 1\n" + lists) +
                    vertices + full + std::string(12, '\0'));
      check_refused(header(form, "element vertex 2\n" + xyz + "property list " + type +
                                     " double other\nelement face 1\n" + list) +
                    std::string(12, '\0') + full + std::string(50, '\0'));
      check_refused(header(form, "element face 1\n" + lists + "element vertex 2\n" + xyz) + full +
                    std::string(60, '\0'));
    }
  }
  const std::string vertices = "0 0 0\n1 1 1\n";
  for (const char* length :
       {"4", "255", "4000000000", "9000000000000000", "99999999999999999999999"}) {
    // A length that no integer holds is no list at all: a face without corners.
    if (std::string(length).size() > 20) continue;
    check_refused(header("ascii", "element vertex 2\n" + xyz + "element face 1\n" + list) +
                  vertices + length + " 0 1 0");
    check_refused(header("ascii", "element vertex 2\n" + xyz +
                                      "property list uint int a\nelement face 1\n" + list) +
                  "0 0 0 " + length + " 1 1 1");
  }
}

TEST_CASE("elements without what they need are refused") {
  const std::string data(1000, '\1');
  for (const std::string& form : forms) {
    for (const char* missing : {"property float x\n", "property float y\n", "property float z\n"}) {
      std::string some = xyz;
      some.erase(some.find(missing), std::string(missing).size());
      check_refused(header(form, "element vertex 2\n" + some + "element face 1\n" + list) + data);
      // A list of that name is no coordinate.
      std::string lists = xyz;
      lists.replace(lists.find(missing), 9, "property list uchar ");
      check_refused(header(form, "element vertex 2\n" + lists + "element face 1\n" + list) + data);
    }
    check_refused(header(form, "element vertex 2\n" + xyz + "element face 1\n") + data);
    check_refused(header(form, "element vertex 2\n" + xyz +
                                   "element face 1\nproperty list uchar int indices\n") +
                  data);
    check_refused(
        header(form, "element vertex 2\n" + xyz + "element face 1\nproperty int vertex_indices\n") +
        data);
    check_refused(header(form, "element vertex 2\n" + xyz +
                                   "element tristrips 1\nproperty int vertex_indices\n") +
                  data);
    check_refused(header(form, "element face 1\n" + list) + data);
    check_refused(header(form, "element vertices 2\n" + xyz + "element face 1\n" + list) + data);
  }
}

TEST_CASE("an element that is declared twice is refused") {
  const std::string vertex =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string more = "property float quality\n";
  for (const std::string& first : {vertex, vertex + more}) {
    check_refused("ply\nformat ascii 1.0\n" + first + vertex +
                  "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                  "0 0 0 0\n0 0 0\n3 0 0 0\n");
  }
}

TEST_CASE("what is no number in an ASCII file is refused with its line") {
  const std::string good = header("ascii", "element vertex 3\n" + xyz + "element face 1\n" + list) +
                           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  REQUIRE_FALSE(try_everything(good, Kind::file).error);
  for (const std::string wrong : {"x", "1,0", "0x1", "\x01\x02", "3;"}) {
    for (const auto& [from, line] :
         std::vector<std::pair<std::string, int>>{{"1 0 0", 11}, {"0 1 0", 12}, {"3 0 1 2", 13}}) {
      std::string file = good;
      const std::size_t at = file.rfind(from);
      file.replace(at, 1, wrong);
      const Outcome outcome = try_everything(file, Kind::file);
      CAPTURE(file);
      REQUIRE(outcome.error);
      CAPTURE(outcome.error->what());
      CHECK(outcome.error->kind() == ErrorKind::bad_input);
      CHECK(std::string(outcome.error->what()).find("line " + std::to_string(line) + ",") !=
            std::string::npos);
    }
  }
}

TEST_CASE("headers without an end are refused") {
  check_refused("ply\n");
  check_refused("ply\nformat ascii 1.0\n");
  check_refused("ply\nformat ascii 1.0\ncomment " + std::string(5'000'000, 'x'));
  check_refused("ply\nformat ascii 1.0\n" + std::string(5'000'000, '\n'));
  std::string elements;
  for (int i = 0; i < 200'000; ++i) elements += "element e 1\n";
  check_refused("ply\nformat ascii 1.0\n" + elements);
}

TEST_CASE("a record of many properties takes no more memory than one of few") {
  // A header of half a mebibyte can make a record of a quarter.
  std::string many;
  for (int i = 0; i < 25'000; ++i) many += "property double p" + std::to_string(i) + "\n";
  const std::string vertices(12 * 3, '\0');
  for (const std::string form : {"binary_little_endian", "ascii"}) {
    for (const Kind kind : {Kind::pipe, Kind::file}) {
      const Outcome wide_vertices = try_everything(
          header(form, "element vertex 100000\n" + xyz + many + "element face 1\n" + list) +
              vertices,
          kind);
      CAPTURE(form, static_cast<int>(kind));
      REQUIRE(wide_vertices.error);
      CHECK(wide_vertices.error->kind() == ErrorKind::bad_input);
    }
  }
  // As it shows in what the source is asked for at once.
  const auto asked_for = [&](const std::string& file) {
    test::TestJob test;
    auto owned = std::make_unique<test::MemorySource>(file, Kind::pipe);
    const std::shared_ptr<std::size_t> largest = std::make_shared<std::size_t>(0);
    class Watched final : public ByteSource {
     public:
      Watched(std::unique_ptr<test::MemorySource> source, std::shared_ptr<std::size_t> most)
          : ByteSource("test", ""), source_(std::move(source)), most_(std::move(most)) {}
      Block take(std::size_t bytes) override {
        *most_ = std::max(*most_, bytes);
        return source_->take(bytes);
      }
      void give_back(std::size_t bytes) override { source_->give_back(bytes); }
      [[nodiscard]] std::uint64_t position() const override { return source_->position(); }
      [[nodiscard]] std::optional<std::uint64_t> size() const override { return {}; }
      [[nodiscard]] bool seekable() const override { return false; }
      void seek(std::uint64_t /*position*/) override {}

     private:
      std::unique_ptr<test::MemorySource> source_;
      std::shared_ptr<std::size_t> most_;
    };
    try {
      test::faces_of(test.job, std::make_unique<Watched>(std::move(owned), largest));
    } catch (const Error&) {
    }
    return *largest;
  };
  const std::string tail = std::string(13, '\3');
  CHECK(asked_for(header("binary_little_endian",
                         "element vertex 100000\n" + xyz + many + "element face 1\n" + list) +
                  vertices) < std::size_t{32} << 20);
  CHECK(asked_for(header("binary_little_endian",
                         "element vertex 3\n" + xyz + "element face 100000\n" + list + many) +
                  vertices + tail) < std::size_t{32} << 20);
}

TEST_CASE("bytes changed at random are an error or another mesh, nothing worse") {
  test::Random random(240);
  for (int round = 0; round < 3000; ++round) {
    const test::Polygons mesh = test::random_polygons(random, random.between(1, 60),
                                                      random.between(0, 60), random.between(3, 6));
    const test::PlyStyle style = random_ply_style(random, mesh);
    std::string file = ply_file(mesh, style);
    for (std::uint64_t changes = random.between(1, 6); changes > 0; --changes) {
      const std::size_t at = random.chance(0.6)
                                 ? random.below(std::min<std::size_t>(file.size(), 400))
                                 : random.below(file.size());
      const std::string bytes = random.one_of<std::string>(
          {"9", "-", "\n", " ", "\xff", std::string(1, '\0'), "list ", "99999", "e", "\r"});
      if (random.chance(0.3)) {
        file.erase(at, random.between(1, 9));
      } else if (random.chance(0.5)) {
        file.insert(at, bytes);
      } else {
        file.replace(at, bytes.size(), bytes);
      }
      if (file.empty()) break;
    }
    for (const Kind kind : {Kind::file, Kind::pipe}) {
      const Outcome outcome = try_everything(file, kind, Format::ply);
      CAPTURE(round, static_cast<int>(kind), file.substr(0, 500));
      if (outcome.error) REQUIRE(outcome.error->kind() == ErrorKind::bad_input);
      REQUIRE(outcome.seconds < 5);
      REQUIRE(outcome.largest_take < std::size_t{32} << 20);
    }
  }
}

}  // namespace winnow
