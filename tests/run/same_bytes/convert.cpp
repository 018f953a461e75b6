// What convert writes depends on the mesh alone: not on threads, memory, file or pipe.
#include "support/simplified.hpp"

namespace winnow::test {

namespace {

std::string converted(const Directory& directory, const Words& arguments, const std::string& output,
                      const Setup& setup = {}) {
  const std::string path = directory.file(output);
  winnow_ok(Words{"convert", "-o", path, "-q"} + arguments, setup);
  const std::string hash = hash_of_file(path);
  ::unlink(path.c_str());
  return hash;
}

void compare(const std::string& format) {
  const Directory directory;
  const std::string input = directory.file("scan." + format);
  generate("scan", 200'000, input);
  const std::string smallest = smallest_memory_of({"convert", input, "--threads", "2"});
  for (const char* output :
       {"out.ply", "out.stl", "out.obj", "out.off", "out.glb", "out.ply.gz", "out.glb.zst"}) {
    INFO(format << " to " << output);
    const std::string right =
        converted(directory, {input, "--threads", "1", "--memory", "8G"}, output);
    CHECK(converted(directory, {input, "--threads", "4"}, output) == right);
    CHECK(converted(directory, {"-", "--threads", "2"}, output, {.in = input}) == right);
    // A little more than the smallest, for the compressor.
    const std::string memory = std::to_string(std::stoi(smallest) + 4) + "M";
    CHECK(converted(directory, {input, "--threads", "2", "--memory", memory}, output) == right);
  }
  Program program({"convert", "-", "-o", directory.file("piped.ply"), "-q"}, {.in = "|"});
  CHECK(program.write(bytes_of_file(input)));
  REQUIRE(program.wait().code == 0);
  CHECK(hash_of_file(directory.file("piped.ply")) == converted(directory, {input}, "out.ply"));
}

}  // namespace

TEST_CASE("the same bytes converted from PLY by any threads memory and route", "[same_bytes]") {
  compare("ply");
}
TEST_CASE("the same bytes converted from STL by any threads memory and route", "[same_bytes]") {
  compare("stl");
}

}  // namespace winnow::test
