// Inputs that cannot be read are refused with 3 and named; none is ever written to.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "support/gltf_file.hpp"
#include "support/simplified.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

namespace winnow::test {

namespace {

void check_refused(const Run& run, const std::string& name) {
  INFO(run.err);
  CHECK(run.signal == 0);
  CHECK(run.code == 3);
  CHECK(run.err.find("'" + name + "'") != std::string::npos);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK(run.out.empty());
}

}  // namespace

TEST_CASE("an input that is not there or no file is refused", "[faults]") {
  const Directory directory;
  const std::string output = directory.file("out.ply");
  for (const Words& options :
       {Words{"--cell", "1"}, Words{"--faces", "100"}, Words{"--grid", "9", "--dry-run"}}) {
    const std::string missing = directory.file("missing.ply");
    check_refused(run_winnow(Words{"simplify", missing, "-o", output} + options), missing);
    check_refused(run_winnow(Words{"simplify", directory.path(), "-o", output} + options),
                  directory.path());
    const std::string inside = directory.file("missing/scan.ply");
    check_refused(run_winnow(Words{"simplify", inside, "-o", output} + options), inside);
    CHECK(directory.names().empty());
    const std::string empty = directory.file("empty.ply");
    write_file(empty, "");
    check_refused(run_winnow(Words{"simplify", empty, "-o", output} + options), empty);
    check_refused(run_winnow(Words{"simplify", "-", "-o", output} + options), "standard input");
    CHECK(directory.names() == Words{"empty.ply"});
    ::unlink(empty.c_str());
  }
}

TEST_CASE("an input that may not be read is refused", "[faults]") {
  const Directory directory;
  ::chmod(directory.path().c_str(), 0777);
  const std::string input = directory.file("secret.ply");
  generate("scan", 2'000, input);
  ::chmod(input.c_str(), 0);
  const Run run = run_winnow({"simplify", input, "-o", directory.file("out.ply"), "--grid", "9"},
                             {.unprivileged = true});
  if (run.code == 97) {
    std::cout << "skipped: another user may not run " << WINNOW_PROGRAM << "\n";
    return;
  }
  check_refused(run, input);
  CHECK(run.err.find("Permission denied") != std::string::npos);
  CHECK(directory.names() == Words{"secret.ply"});
}

TEST_CASE("an input is never written to", "[faults]") {
  const Directory directory;
  for (const char* name : {"scan.ply", "scan.stl"}) {
    const std::string input = directory.file(name);
    generate("scan", 50'000, input);
    const std::string gzip = gzip_file(input);
    const Words before = directory.names();
    Words hashes;
    for (const std::string& file : before) hashes.push_back(hash_of_file(directory.file(file)));
    const std::string output = directory.file("out.ply");
    // Runs that succeed, fail at the start, fail at the end, are refused.
    for (const std::string& from : {input, gzip}) {
      run_winnow({"simplify", from, "-o", output, "--faces", "1000", "--force"});
      run_winnow({"simplify", from, "-o", output, "--cell", "-1"});
      run_winnow({"simplify", from, "-o", output, "--cell", "0.001", "--force"},
                 {.largest_file = 10'000});
      run_winnow({"simplify", from, "-o", from, "--grid", "10"});
      ::unlink(output.c_str());
    }
    CHECK(directory.names() == before);
    for (std::size_t i = 0; i < before.size(); ++i)
      CHECK(hash_of_file(directory.file(before[i])) == hashes[i]);
    ::unlink(input.c_str());
    ::unlink(gzip.c_str());
  }
}

TEST_CASE("an input is not replaced by its own result", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 20'000, input);
  const std::string before = hash_of_file(input);
  CHECK(run_winnow({"simplify", input, "-o", input, "--grid", "20", "--force"}).code == 2);
  CHECK(hash_of_file(input) == before);
  CHECK(directory.names() == Words{"scan.ply"});
}

TEST_CASE("an input that is changed while it is read is refused, whatever is read and how often",
          "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 50'000, input);
  const std::string other = directory.file("other.stl");
  generate("scan", 1'000, other);
  for (const std::string& name : {input, directory.file("scan.stl"), gzip_file(input),
                                  ascii_file(input, directory.file("scan.obj"))}) {
    if (!exists(name)) generate("scan", 50'000, name);
    for (const bool several : {false, true}) {
      std::vector<std::string> inputs{name};
      if (several) inputs.push_back(other);
      bool written = false;
      Context context;
      context.threads = 2;
      context.progress = [&](const Progress&) {
        if (written) return;
        std::filesystem::last_write_time(name, std::filesystem::file_time_type::clock::now());
        written = true;
      };
      SimplifyOptions options;
      options.target = Target::faces(1000);
      CAPTURE(name, several);
      try {
        simplify(context, inputs, directory.file("out.ply"), options);
        CHECK_FALSE("an error");
      } catch (const Error& error) {
        INFO(error.what());
        CHECK(error.kind() == ErrorKind::bad_input);
        CHECK(std::string(error.what()).find("'" + name + "' was changed") != std::string::npos);
      }
      CHECK(written);
      CHECK_FALSE(exists(directory.file("out.ply")));
    }
  }
}

TEST_CASE("a file beside a glTF that is changed during the run is refused as the glTF is",
          "[faults]") {
  const Directory directory;
  Polygons mesh;
  constexpr std::int64_t side = 150;
  for (std::int64_t i = 0; i < side * side; ++i) {
    mesh.vertices.push_back({static_cast<double>(i % side), static_cast<double>(i / side), 0});
    if (i % side == 0 || i < side) continue;
    mesh.faces.push_back({i, i - 1, i - side});
    mesh.faces.push_back({i - 1, i - side - 1, i - side});
  }
  const GltfBuilder builder = gltf_of(mesh);
  const std::string input = directory.file("in.gltf");
  write_file(input, builder.gltf("beside.bin"));
  const std::string other = directory.file("other.stl");
  generate("scan", 1'000, other);
  const std::string beside = directory.file("beside.bin");
  const auto touch = [&] {
    std::filesystem::last_write_time(beside, std::filesystem::file_time_type::clock::now());
  };
  const auto cut = [&] { std::filesystem::resize_file(beside, builder.buffer.size() - 8); };
  const auto replace = [&] {
    write_file(directory.file("new.bin"), builder.buffer);
    std::filesystem::rename(directory.file("new.bin"), beside);
  };
  const auto leave = [] {};
  const std::vector<std::pair<std::string, std::function<void()>>> changes{
      {"was changed", touch}, {"was shortened", cut}, {"was changed", replace}, {"", leave}};
  for (const auto& [told, change] : changes) {
    for (const Words& inputs : {Words{input}, Words{input, other}}) {
      write_file(beside, builder.buffer);
      bool read = false, written = false;
      Context context;
      context.threads = 2;
      context.progress = [&, &what = change](const Progress& progress) {
        read = read || std::string(progress.stage) == "read the mesh";
        if (!read || written || std::string(progress.stage) == "read the mesh") return;
        what();
        written = true;
      };
      SimplifyOptions options;
      options.target = Target::faces(1000);
      std::string message;
      try {
        simplify(context, inputs, directory.file("out.ply"), options);
      } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::bad_input);
        message = error.what();
      }
      CAPTURE(told, message, inputs.size());
      CHECK(written);
      CHECK(exists(directory.file("out.ply")) == told.empty());
      CHECK(message.empty() == told.empty());
      CHECK(message.find(told.empty() ? "" : "'" + beside + "' " + told) != std::string::npos);
      ::unlink(directory.file("out.ply").c_str());
    }
  }
}

TEST_CASE("a named pipe is an input", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 20'000, input);
  const std::string want = simplified(directory, input, {"--grid", "20"}).hash;
  const std::string pipe = directory.file("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  Program program({"simplify", pipe, "-o", directory.file("out.ply"), "--grid", "20"});
  const std::string bytes = bytes_of_file(input);
  std::thread writer([&] {
    const int fd = ::open(pipe.c_str(), O_WRONLY | O_CLOEXEC);
    std::size_t at = 0;
    for (ssize_t done = 1; done > 0 && at < bytes.size();
         at += static_cast<std::size_t>(std::max<ssize_t>(0, done))) {
      done = ::write(fd, bytes.data() + at, bytes.size() - at);
    }
    ::close(fd);
  });
  const Run run = program.wait();
  // Lets go of a writer that nobody came for.
  const int fd = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  writer.join();
  ::close(fd);
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK(hash_of_file(directory.file("out.ply")) == want);
}

}  // namespace winnow::test
