// Lines of text that are longer than any block.
#include "support/budget.hpp"
#include "support/files.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// A regular polygon of so many corners.
struct LongPolygon {
  explicit LongPolygon(std::size_t corners) {
    std::string places, numbers, from_one;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
      const std::string place = std::to_string(1000 * std::cos(angle)) + " " +
                                std::to_string(1000 * std::sin(angle)) + " 0\n";
      const std::string next = std::to_string(i + 1);
      places += place;
      obj += "v " + place;
      m += "Vertex " + next + " " + place;
      numbers += " " + std::to_string(i);
      from_one += " " + next;
    }
    const std::string count = std::to_string(corners);
    obj += "f" + from_one + "\n";
    m += "Face 1" + from_one + "\n";
    off = "OFF\n" + count + " 1 0\n" + places + count + numbers + "\n";
  }

  std::string obj, off, m;
};

// Three corners, far apart on their line.
std::string sparse_lines(int lines, std::size_t blanks) {
  std::string file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (int i = 0; i < lines; ++i)
    file += "f" + std::string(blanks, ' ') + "1 2" + std::string(blanks, '\t') +
            std::to_string(3 + i % 2) + "\n";
  return file + "f 1 3 4\n";
}

}  // namespace

TEST_CASE("a polygon of 400,000 corners on one line is read in every text format", "[long]") {
  const Directory directory;
  const LongPolygon polygon(400'000);
  const std::string hash = [&] {
    write_file(directory.file("polygon.obj"), polygon.obj);
    winnow_ok({"convert", directory.file("polygon.obj"), "-o", directory.file("once.ply"), "-q"});
    return hash_of_file(directory.file("once.ply"));
  }();
  for (const auto& [name, file] :
       {std::pair("a.obj", &polygon.obj), {"a.off", &polygon.off}, {"a.m", &polygon.m}}) {
    const std::string path = directory.file(name);
    write_file(path, *file);
    for (const Words& from :
         {Words{path, "--threads", "1"}, {path, "--threads", "5"}, {zstd_file(path)}}) {
      INFO(joined(from));
      const Run run =
          winnow_ok(Words{"convert", "-o", directory.file("out.ply"), "--force", "--json"} + from);
      CHECK(run.json()["output"]["faces"] == 399'998);
      CHECK(hash_of_file(directory.file("out.ply")) == hash);
    }
    CHECK(winnow_ok({"info", "-", "--json"}, {.in = path}).json()["faces"] == 399'998);
  }
}

TEST_CASE("a line may be as long as the budget allows, and an error names one that is enough",
          "[budget]") {
  const Directory directory;
  const std::string path = directory.file("lines.obj");
  write_file(path, sparse_lines(1, 6'000'000));
  const Words command{"info", path, "--json"};
  const Run refused = run_winnow(command + Words{"--memory", "64M"});
  INFO(refused.err);
  REQUIRE(refused.code == 4);
  const std::string error = refused.json()["error"]["message"];
  CHECK(error.find("line 5 of '") != std::string::npos);
  CHECK(error.find("11.4 MiB") != std::string::npos);
  const std::string memory = named_memory(refused);
  check_peak(run_winnow(command + Words{"--memory", memory}), memory);
  check_peak(run_winnow({"info", "-", "--json", "--memory", memory}, {.in = path}), memory);
}

TEST_CASE("several long lines need no more memory than one, whatever the threads", "[budget]") {
  const Directory directory;
  const std::string one = directory.file("one.obj");
  const std::string more = directory.file("more.obj");
  write_file(one, sparse_lines(1, 3'000'000));
  write_file(more, sparse_lines(6, 3'000'000));
  for (const char* threads : {"1", "2", "16"}) {
    const Words options{"--json", "--threads", threads};
    const std::string memory = enough_memory(Words{"info", one} + options);
    INFO(threads << " threads, " << memory);
    const Run run = run_winnow(Words{"info", more, "--memory", memory} + options);
    check_peak(run, memory);
    CHECK(run.json()["faces"] == 7);
  }
}

}  // namespace winnow::test
