// An input that another program shortens while it is read ends in an error that says so: never in a
// death by SIGBUS, never in a result of zeros.
#include <winnow/error.hpp>
#include <winnow/mapped_guard.hpp>
#include <winnow/simplify.hpp>

#include "support/simplified.hpp"

#include <csignal>
#include <filesystem>
#include <sstream>

#include <unistd.h>

namespace winnow::test {

namespace {

enum class Route { mapped, read };

// Runs on a copy of `input` that is cut to `length` bytes when `stage` begins: to the byte the same
// place each time.
void check_shrinking(const Directory& directory, const std::string& input,
                     const SimplifyOptions& options, const std::string& stage, std::uint64_t length,
                     Route route) {
  const std::string copy = directory.file("copy");
  std::filesystem::copy_file(input, copy, std::filesystem::copy_options::overwrite_existing);
  const std::string output = directory.file("out.ply");
  Context context;
  context.threads = 2;
  context.map_input = route == Route::mapped;
  bool cut = false;
  context.progress = [&](const Progress& progress) {
    if (cut || progress.stage != stage) return;
    cut = ::truncate(copy.c_str(), static_cast<off_t>(length)) == 0;
  };
  int code = 0;
  std::string message;
  try {
    simplify(context, copy, output, options);
  } catch (const Error& error) {
    code = error.exit_code();
    message = error.what();
  }
  INFO(input << " cut to " << length << " bytes in stage '" << stage << "', "
             << (route == Route::mapped ? "mapped" : "read") << ": " << message);
  CHECK(cut);
  CHECK(code == 3);
  CHECK(message.find("shortened") != std::string::npos);
  CHECK(message.find("copy") != std::string::npos);
  CHECK_FALSE(exists(output));
  ::unlink(output.c_str());
}

// Quads, so that records are found one after the other.
std::string quads_file(const std::string& path, std::uint32_t side) {
  std::ostringstream text;
  text << "ply\nformat binary_little_endian 1.0\nelement vertex " << std::uint64_t{side} * side
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
       << std::uint64_t{side - 1} * (side - 1)
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto put = [&](const auto& value) {
    text.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (std::uint32_t i = 0; i < side * side; ++i) {
    for (const float value : {static_cast<float>(i % side), static_cast<float>(i / side), 0.0F})
      put(value);
  }
  for (std::uint32_t y = 0; y + 1 < side; ++y) {
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t at = y * side + x;
      put(std::uint8_t{4});
      for (const std::uint32_t corner : {at, at + 1, at + side + 1, at + side}) put(corner);
    }
  }
  write_file(path, text.str());
  return path;
}

SimplifyOptions with_cell(double cell) {
  SimplifyOptions options;
  options.target = Target::cell(cell);
  return options;
}

SimplifyOptions with_faces(std::uint64_t faces) {
  SimplifyOptions options;
  options.target = Target::faces(faces);
  options.refine = Refine::none;
  return options;
}

SimplifyOptions refined(std::uint64_t faces) {
  SimplifyOptions options;
  options.target = Target::faces(faces);
  return options;
}

// To nothing, within the vertices, among the faces, by the last two pages.
std::vector<std::uint64_t> lengths(const std::string& input) {
  const std::uint64_t size = size_of_file(input);
  return {0, size / 5, size / 2, size - 2 * 4096};
}

}  // namespace

TEST_CASE("a file that shrinks while it is mapped is an error", "[faults]") {
  guard_mapped_files();
  const Directory directory;
  const std::string ply = directory.file("scan.ply");
  generate("scan", 300'000, ply);
  const std::string stl = directory.file("scan.stl");
  generate("scan", 100'000, stl);
  const std::string ascii = ascii_file(stl, directory.file("ascii.stl"));
  for (const std::string& input : {ply, stl, ascii}) {
    for (const std::uint64_t length : lengths(input)) {
      check_shrinking(directory, input, with_cell(0.05), "cluster", length, Route::mapped);
      check_shrinking(directory, input, with_cell(0.05), "cluster", length, Route::read);
    }
  }
  for (const std::string& input : {ply, stl}) {
    check_shrinking(directory, input, with_faces(5000), "sample", size_of_file(input) / 5,
                    Route::mapped);
    check_shrinking(directory, input, with_faces(5000), "cluster", size_of_file(input) / 2,
                    Route::mapped);
    check_shrinking(directory, input, refined(5000), "weld", size_of_file(input) / 5,
                    Route::mapped);
    check_shrinking(directory, input, refined(5000), "join faces", size_of_file(input) / 2,
                    Route::mapped);
  }
}

TEST_CASE("a file of polygons that shrinks while it is mapped is an error", "[faults]") {
  guard_mapped_files();
  const Directory directory;
  const std::string quads = quads_file(directory.file("quads.ply"), 300);
  for (const std::uint64_t length : lengths(quads)) {
    check_shrinking(directory, quads, with_cell(20), "cluster", length, Route::mapped);
    check_shrinking(directory, quads, with_cell(20), "cluster", length, Route::read);
  }
}

TEST_CASE("an ASCII PLY that shrinks while it is mapped is an error", "[faults]") {
  guard_mapped_files();
  const Directory directory;
  const std::string binary = directory.file("scan.ply");
  generate("scan", 100'000, binary);
  const std::string ascii = ascii_file(binary, directory.file("ascii.ply"));
  check_shrinking(directory, ascii, with_cell(0.05), "read vertices", size_of_file(ascii) / 5,
                  Route::mapped);
  check_shrinking(directory, ascii, with_cell(0.05), "cluster", size_of_file(ascii) - 2 * 4096,
                  Route::mapped);
}

// Within a page there is no SIGBUS: the lost bytes read as zeros.
TEST_CASE("a file that loses its last bytes while it is mapped is an error", "[faults]") {
  guard_mapped_files();
  const Directory directory;
  for (const char* name : {"scan.ply", "scan.stl"}) {
    const std::string input = directory.file(name);
    generate("scan", 100'000, input);
    const std::uint64_t size = size_of_file(input);
    check_shrinking(directory, input, with_cell(0.05), "cluster",
                    size - std::min<std::uint64_t>(30, size % 4096), Route::mapped);
  }
}

TEST_CASE("the program survives an input that shrinks", "[faults]") {
  const Directory directory;
  for (const char* name : {"scan.ply", "scan.stl"}) {
    const std::string input = directory.file(name);
    generate("scan", 1'500'000, input);
    Program program({"simplify", input, "-o", directory.file("out.ply"), "--cell", "0.01",
                     "--threads", "1", "--progress", "json"},
                    {.err = "|"});
    // It says that it begins to cluster; it is stopped, the file is cut, it goes on.
    std::string told;
    while (told.find("cluster") == std::string::npos) {
      const std::string part = program.read_err();
      if (part.empty()) break;
      told += part;
    }
    ::kill(program.pid(), SIGSTOP);
    REQUIRE(::truncate(input.c_str(), static_cast<off_t>(size_of_file(input) / 2)) == 0);
    ::kill(program.pid(), SIGCONT);
    for (std::string part = program.read_err(); !part.empty(); part = program.read_err())
      told += part;
    const Run run = program.wait();
    INFO(told);
    CHECK(run.signal == 0);
    CHECK(run.code == 3);
    CHECK(told.find("'" + input + "' was shortened by another program") != std::string::npos);
    CHECK(directory.names() == Words{name});
    ::unlink(input.c_str());
  }
}

}  // namespace winnow::test
