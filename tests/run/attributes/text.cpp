// Attributes of a PLY in ASCII are those of a binary one, to the bit.
#include "support/attributes.hpp"
#include "support/simplified.hpp"

namespace winnow::test {

TEST_CASE("attributes written as text are read as the same numbers") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const std::string text = directory.file("text.ply");
  std::vector<Column> columns = usual_columns();
  columns.push_back({"low", NumberType::int8, [](const Point& p) { return 100 * p[0]; }});
  columns.push_back({"count", NumberType::uint16, [](const Point&) { return 65535; }});
  write_attributed(in, generated(directory.path(), 4000), columns);
  const std::string binary = directory.file("binary.ply");
  const Words options{"--faces", "1000", "-q"};
  winnow_ok(Words{"simplify", in, "-o", binary} + options);
  winnow_ok(Words{"simplify", in, "-o", text, "--ascii"} + options);
  // Nothing goes the second time.
  const Simplified again = simplified(directory, text, {"--faces", "1000"});
  CHECK(again.hash == simplified(directory, binary, {"--faces", "1000"}).hash);
  CHECK(again.report["attributes"]["carried"].size() == columns.size());
}

}  // namespace winnow::test
