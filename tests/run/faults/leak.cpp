// A call that fails gives all its memory back: a server makes many.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "support/simplified.hpp"

#include <malloc.h>

namespace winnow::test {

namespace {

// Bytes that malloc has handed out, in arenas and mapped.
std::size_t allocated() {
  const struct mallinfo2 info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

// Runs that end in an error of this kind; what they leave behind, in bytes a run.
std::size_t left_by(const std::string& input, const std::string& output, int code) {
  constexpr std::size_t runs = 30;
  std::size_t before = 0;
  for (std::size_t i = 0; i < runs + 4; ++i) {
    if (i == 4) before = allocated();  // what is made once, by whatever library, has been made
    Context context;
    context.threads = 4;
    SimplifyOptions options;
    options.target = Target::cell(0.001);
    int found = 0;
    try {
      winnow::simplify(context, input, output, options);
    } catch (const Error& error) {
      found = error.exit_code();
    }
    CHECK(found == code);
  }
  const std::size_t after = allocated();
  return after > before ? (after - before) / runs : 0;
}

}  // namespace

TEST_CASE("failing calls leave no memory behind", "[faults]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 100'000, input);
  CHECK(left_by(input, "/dev/full", 4) < 4096);
  const std::string cut = directory.file("cut.ply.gz");
  const std::string packed = bytes_of_file(gzip_file(input));
  write_file(cut, packed.substr(0, packed.size() * 9 / 10));
  CHECK(left_by(cut, directory.file("out.ply"), 3) < 4096);
}

}  // namespace winnow::test
