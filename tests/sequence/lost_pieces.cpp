// What goes from a sequence as a whole is told, and so is its area.
#include "support/moving_sheet.hpp"
#include "support/simplified.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

TEST_CASE("pieces and area that go from a sequence are told") {
  const Directory directory;
  const MovingSheet sheet{10};
  constexpr std::uint32_t tatters = 30;
  Words names;
  for (std::size_t frame = 0; frame < 3; ++frame) {
    std::vector<Point> positions = sheet.positions(frame);
    std::vector<std::array<std::uint32_t, 3>> faces = sheet.faces();
    for (std::uint32_t i = 0; i < tatters; ++i) {
      const auto first = static_cast<std::uint32_t>(positions.size());
      const Point at{2, 0.1 * i, 0.01 * static_cast<double>(frame)};
      for (const Point& corner : {Point{0, 0, 0}, Point{0.08, 0, 0}, Point{0, 0.08, 0.01}})
        positions.push_back(at + corner);
      faces.push_back({first, first + 1, first + 2});
    }
    names.push_back(directory.file("f-" + std::to_string(frame) + ".obj"));
    write_file(names.back(), obj_of(positions, faces));
  }
  const Words to{"-o", directory.file("s-{frame}.ply"), "--json", "--force"};
  const auto all = winnow_ok(Words{"sequence"} + names + to + Words{"--ratio", "100%"}).json();
  CHECK(all["lost"]["pieces"] == 0);
  CHECK(all["notes"].empty());
  CHECK(all["area"]["output"].get<double>() ==
        Approx(all["area"]["input"].get<double>()).epsilon(1e-6));
  const auto few = winnow_ok(Words{"sequence"} + names + to + Words{"--faces", "20"}).json();
  const auto pieces = few["lost"]["pieces"].get<std::uint64_t>();
  CHECK(pieces >= tatters - 20);
  CHECK(pieces <= tatters);
  const double area = few["lost"]["piece_area"];
  CHECK(area == Approx(0.0032 * static_cast<double>(pieces)).epsilon(0.1));
  CHECK(few["area"]["output"] < 0.98 * few["area"]["input"].get<double>());
  REQUIRE(few["notes"].size() == 1);
  CHECK_THAT(few["notes"][0].get<std::string>(),
             Catch::StartsWith("in the first frame ") && Catch::EndsWith(" of the area is gone"));
}

}  // namespace winnow::test
