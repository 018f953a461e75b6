// A comparison stays within the budget, whatever the size of the original; what the messages call
// enough is.
#include "support/budget.hpp"
#include "support/random.hpp"

#include <array>
#include <cstring>

namespace winnow::test {

TEST_CASE("a comparison stays within the budget", "[budget]") {
  const Directory directory;
  const std::string original = directory.file("scan.ply");
  const std::string small = directory.file("small.ply");
  generate("scan", 1'000'000, original);
  winnow_ok({"simplify", original, "-o", small, "--faces", "20k"});
  const std::string packed = zstd_file(original);
  const Words pictured{original,    small,
                       "--picture", directory.file("picture.png"),
                       "--colored", directory.file("colored.ply"),
                       "--force"};
  for (const Words& what : {Words{original, small}, Words{packed, small}, pictured}) {
    const Words arguments =
        Words{"compare", "--json", "--samples", "100k", "--threads", "2"} + what;
    const std::string enough = enough_memory(arguments);
    INFO(joined(arguments) << " --memory " << enough);
    check_peak(run_winnow(arguments + Words{"--memory", enough}), enough);
    check_peak(run_winnow(arguments + Words{"--memory", "256M"}), "256M");
  }
}

TEST_CASE("a comparison of loose faces stays within the budget", "[budget]") {
  const Directory directory;
  const std::string soup = directory.file("soup.stl");
  Random random(740);
  std::string file(84, ' ');
  constexpr std::uint32_t faces = 300'000;
  std::memcpy(file.data() + 80, &faces, 4);
  for (std::uint32_t f = 0; f < faces; ++f) {
    std::array<float, 12> record{};
    const auto place = static_cast<float>(f);
    for (std::size_t i = 3; i < 12; ++i) record[i] = place + static_cast<float>(random.unit());
    file.append(reinterpret_cast<const char*>(record.data()), sizeof record);
    file.append(2, '\0');
  }
  write_file(soup, file);
  const Words arguments{"compare", soup, soup, "--json", "--samples", "10k", "--threads", "2"};
  const std::string enough = enough_memory(arguments);
  INFO(enough);
  check_peak(run_winnow(arguments + Words{"--memory", enough}), enough);
}

TEST_CASE("what is called enough for many threads is enough", "[budget]") {
  const Directory directory;
  const std::string mesh = directory.file("scan.ply");
  generate("scan", 30'000, mesh);
  for (const std::string& original : {mesh, zstd_file(mesh)})
    enough_memory({"compare", original, mesh, "--json", "--threads", "48", "--samples", "1000"});
}

}  // namespace winnow::test
