// Who may read and write an output.
#include "io/byte_sink.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/sources.hpp"

#include <string>

#include <catch2/catch.hpp>
#include <sys/stat.h>

namespace winnow {

namespace {

unsigned mode_of(const std::string& path) {
  struct stat status {};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777U;
}

// The umask of the process, for as long as the object lives.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t before_;
};

}  // namespace

TEST_CASE("a replaced file hands its mode on") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  for (const unsigned mode : {0600U, 0644U, 0664U, 0755U, 0400U}) {
    const Umask mask(077);
    test::TestJob test;
    std::filesystem::remove(path);
    test::write_file(path, "old");
    REQUIRE(::chmod(path.c_str(), mode) == 0);
    ByteSink sink(test.job, path, true);
    sink.write(test::bytes_of("new"));
    sink.finish();
    CAPTURE(mode);
    CHECK(mode_of(path) == mode);
    CHECK(test::bytes_of_file(path) == "new");
  }
}

TEST_CASE("a new file gets the mode of any new file") {
  const test::Directory directory;
  for (const mode_t mask : {0, 022, 077}) {
    const Umask now(mask);
    const std::string path = directory.file("out" + std::to_string(mask));
    test::TestJob test;
    ByteSink sink(test.job, path, false);
    sink.finish();
    CHECK(mode_of(path) == (0666U & ~mask));
    const mode_t after = ::umask(mask);
    CHECK(after == mask);  // looking at it did not change it
  }
}

TEST_CASE("a new output takes over who may read the old one, but no rights to act as its owner") {
  const test::Directory directory;
  const std::string path = directory.file("out.ply");
  for (const mode_t mode : {04755, 02755, 01640, 07777}) {
    test::write_file(path, "old");
    REQUIRE(::chmod(path.c_str(), mode) == 0);
    test::TestJob test;
    ByteSink sink(test.job, path, true);
    sink.write(test::bytes_of("new"));
    sink.finish();
    CHECK(mode_of(path) == (mode & 0777U));
  }
}

}  // namespace winnow
