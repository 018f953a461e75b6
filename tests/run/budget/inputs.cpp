// Every way in stays within the budget: the peak of the child's resident set, mapped pages
// included.
#include "support/budget.hpp"

#include <fstream>

namespace winnow::test {

namespace {

constexpr std::uint64_t faces = 1'600'000;
const Words coarse{"--cell", "0.01", "--threads", "2"};

void check_pipe(const Directory& directory, const std::string& input, const Words& options) {
  const std::string memory = smallest_memory(input, options);
  const std::string output = directory.file("out.ply");
  Program program(Words{"simplify", "-", "-o", output, "--json", "--memory", memory} + options,
                  {.in = "|"});
  std::ifstream file(input, std::ios::binary);
  std::string part(1 << 16, '\0');
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0) {
    if (!program.write(part.substr(0, static_cast<std::size_t>(file.gcount())))) break;
  }
  INFO("a pipe of " << input << " " << joined(options));
  check_peak(program.wait(), memory);
  ::unlink(output.c_str());
}

}  // namespace

TEST_CASE("a PLY file stays within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", faces, input);
  for (const char* memory : {"smallest", "64M", "128M"})
    check_budget(directory, input, coarse, memory);
  for (const Words& options :
       {Words{"--grid", "300"}, Words{"--faces", "300k", "--refine", "none"},
        Words{"--ratio", "50%", "--refine", "none", "--placement", "quadric"}}) {
    check_budget(directory, input, options, "smallest");
  }
}

TEST_CASE("an STL file stays within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.stl");
  generate("scan", faces, input);
  for (const char* memory : {"smallest", "64M", "128M"})
    check_budget(directory, input, coarse, memory);
  for (const Words& options :
       {Words{"--grid", "300"}, Words{"--faces", "300k", "--refine", "none"}}) {
    check_budget(directory, input, options, "smallest");
  }
}

TEST_CASE("a pipe stays within the budget", "[budget]") {
  const Directory directory;
  for (const char* name : {"scan.ply", "scan.stl"}) {
    const std::string input = directory.file(name);
    generate("scan", faces, input);
    check_pipe(directory, input, coarse);
    check_pipe(directory, input, {"--faces", "300k", "--refine", "none"});
  }
}

TEST_CASE("ASCII stays within the budget", "[budget]") {
  const Directory directory;
  const std::string binary = directory.file("scan.ply");
  generate("scan", faces / 2, binary);
  check_budget(directory, ascii_file(binary, directory.file("ascii.ply")), coarse, "smallest");
  const std::string stl = directory.file("scan.stl");
  generate("scan", faces / 4, stl);
  check_budget(directory, ascii_file(stl, directory.file("ascii.stl")), coarse, "smallest");
}

TEST_CASE("OBJ, OFF, .m and GLB stay within the budget", "[budget]") {
  const Directory directory;
  const std::string binary = directory.file("scan.ply");
  generate("scan", faces / 2, binary);
  for (const std::string name : {"other.obj", "other.off", "other.m", "other.glb"}) {
    const std::string other = name.ends_with(".glb") ? glb_file(binary, directory.file(name))
                                                     : ascii_file(binary, directory.file(name));
    check_budget(directory, other, coarse, "smallest");
    check_pipe(directory, other, {"--faces", "300k", "--refine", "none"});
  }
}

TEST_CASE("several files stay within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", faces / 2, input);
  const std::string text = ascii_file(input, directory.file("scan.obj"));
  const Words others{zstd_file(input), text};
  check_budget(directory, input, others + coarse, "48M");
}

TEST_CASE("compressed input stays within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", faces, input);
  // Where zstd's own memory is not in the first message, it is in the second.
  const std::string packed = zstd_file(input);
  const std::string plain = smallest_memory(input, coarse);
  check_budget(directory, packed, coarse, smallest_memory(packed, coarse, plain));
  check_budget(directory, gzip_file(input), coarse, "smallest");
}

TEST_CASE("many threads stay within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", faces, input);
  check_budget(directory, input, {"--faces", "300k", "--refine", "none", "--threads", "16"},
               "smallest");
  check_budget(directory, input, {"--cell", "0.003", "--threads", "64", "--placement", "quadric"},
               "smallest");
}

}  // namespace winnow::test
