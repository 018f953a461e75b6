// Colours as reals: up to 1, a little above it, or up to 255.
#include <winnow/convert.hpp>
#include <winnow/simplify.hpp>

#include "support/attributes.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/notes.hpp"
#include "support/program.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// Of one colour everywhere, written as so much.
std::vector<Column> one_color(double full, const std::array<const char*, 3>& names) {
  std::vector<Column> columns;
  const std::array<double, 3> color{0.8, 0.4, 0.2};
  for (std::size_t i = 0; i < 3; ++i)
    columns.push_back(
        {names[i], NumberType::float32, [=](const Point&) { return color[i] * full; }});
  return columns;
}

const std::array<const char*, 3> usual{"red", "green", "blue"};

}  // namespace

TEST_CASE("reals up to 255 are the same colours in every format") {
  const Directory directory;
  const AttributedMesh mesh = generated(directory.path(), 5000);
  for (const auto& names : {usual, std::array{"r", "g", "b"},
                            std::array{"diffuse_red", "diffuse_green", "diffuse_blue"}}) {
    for (const char* ending : {"obj", "off", "glb"}) {
      CAPTURE(names[0], ending);
      std::vector<std::string> bytes;
      for (const double full : {1.0, 255.0}) {
        const std::string input = directory.file("in.ply");
        write_attributed(input, mesh, one_color(full, names));
        for (const bool convert_only : {false, true}) {
          const std::string output = directory.file(std::string("out.") + ending);
          Context context;
          std::vector<std::string> notes;
          if (convert_only) {
            notes = convert(context, input, output, {}).notes;
          } else {
            SimplifyOptions options;
            options.target = Target::ratio(0.5);
            notes = simplify(context, input, output, options).notes;
          }
          CHECK(has_note(notes, "255 was taken for 1") == (full == 255));
          bytes.push_back(bytes_of_file(output));
          ::unlink(output.c_str());
        }
      }
      // Of 0.8 of 255 in floats a little is rounded off.
      if (std::string(ending) != "off") continue;
      CHECK(bytes[0] == bytes[2]);
      CHECK(bytes[1] == bytes[3]);
    }
  }
}

TEST_CASE("reals a little above 1 are clipped, and told of") {
  const Directory directory;
  const AttributedMesh mesh = generated(directory.path(), 5000);
  const std::string input = directory.file("in.ply");
  write_attributed(input, mesh, one_color(2, usual));
  Context context;
  SimplifyOptions options;
  options.target = Target::ratio(0.5);
  const std::string output = directory.file("out.ply");
  const SimplifyReport report = simplify(context, input, output, options);
  CHECK(has_note(report.notes, "(up to 1.6) were clipped"));
  const AttributedMesh out = read_attributed(output);
  for (const double red : out.columns.at("red")) REQUIRE(red == 1);
  for (const double green : out.columns.at("green")) REQUIRE(std::abs(green - 0.8) < 1e-6);
}

}  // namespace winnow::test
