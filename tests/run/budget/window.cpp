// zstd content can ask for a history of up to 2 GiB (zstd --long): it counts, and where it does not
// fit the message says what would.
#include "support/budget.hpp"

#include <fstream>
#include <memory>

#include <zstd.h>

namespace winnow::test {

namespace {

// As `zstd --long=27` does: the size of the content not in the header, a window of 128 MiB.
std::string zstd_long(const std::string& path) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog, 27);
  std::ifstream in(path, std::ios::binary);
  std::ofstream out(path + ".long.zst", std::ios::binary);
  std::string plain(1 << 17, '\0');
  std::string packed(1 << 18, '\0');
  for (bool last = false; !last;) {
    in.read(plain.data(), static_cast<std::streamsize>(plain.size()));
    last = in.gcount() < static_cast<std::streamsize>(plain.size());
    ZSTD_inBuffer from{plain.data(), static_cast<std::size_t>(in.gcount()), 0};
    for (std::size_t left = 1; left != 0 && (last || from.pos < from.size);) {
      ZSTD_outBuffer into{packed.data(), packed.size(), 0};
      left = ZSTD_compressStream2(context.get(), &into, &from, last ? ZSTD_e_end : ZSTD_e_continue);
      out.write(packed.data(), static_cast<std::streamsize>(into.pos));
    }
  }
  return path + ".long.zst";
}

}  // namespace

TEST_CASE("a zstd window counts against the budget", "[budget]") {
  const Directory directory;
  const std::string plain = directory.file("scan.stl");
  generate("scan", 3'000'000, plain);
  const std::string input = zstd_long(plain);
  const std::string output = directory.file("out.ply");
  const Words arguments{"simplify", input,       "-o", output,   "--cell",
                        "0.02",     "--threads", "2",  "--json", "--memory"};
  const Run small = run_winnow(arguments + Words{"64M"});
  INFO(small.err);
  REQUIRE(small.code == 4);
  CHECK(directory.names().size() == 2);
  // What the message asks for is enough, and kept to.
  const std::size_t at = small.err.rfind(' ') + 1;
  const std::string enough = small.err.substr(at, small.err.find('M', at) + 1 - at);
  INFO("--memory " << enough);
  check_peak(run_winnow(arguments + Words{enough}), enough);
}

TEST_CASE("the smallest budget for compressed input works", "[budget]") {
  const Directory directory;
  const std::string plain = directory.file("scan.ply");
  generate("scan", 400'000, plain);
  const std::string input = zstd_file(plain);
  const Words options{"--cell", "0.02", "--threads", "2"};
  const std::string memory = smallest_memory(input, options);
  const std::string output = directory.file("out.ply");
  const Words arguments =
      Words{"simplify", input, "-o", output, "--json", "--memory", memory} + options;
  const nlohmann::json plan = winnow_ok(arguments + Words{"--dry-run"}).json();
  CHECK(plan["smallest_memory"] == bytes_of_size(memory));
  check_peak(run_winnow(arguments), memory);
}

}  // namespace winnow::test
