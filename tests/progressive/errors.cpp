// Levels within an error keep what simplify() with that error keeps, whatever the mesh is made of.
#include <winnow/error.hpp>

#include "meshes.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"
#include "support/refined_shape.hpp"

namespace winnow::test {

namespace {

double diagonal_of(ProgressivePlace& place, const std::string& file) {
  const ProgressiveInfo info = progressive_info(place.context, file);
  return length(info.box_max - info.box_min);
}

CompareReport judged(ProgressivePlace& place, const std::string& mesh, const std::string& level) {
  CompareOptions options;
  options.samples = 50'000;
  return compare(place.context, mesh, level, options);
}

// Larger errors leave fewer faces, and each level is within its own.
void check_levels(ProgressivePlace& place, const std::string& mesh,
                  const ProgressiveOptions& options = {}) {
  const std::string file = place.made(mesh, options);
  const double diagonal = diagonal_of(place, file);
  std::uint64_t faces = place.report.output.faces + 1;
  for (const double part : {2e-4, 1e-3, 5e-3}) {
    const std::string level = place.extracted(file, Target::error(Distance::of_diagonal(part)));
    const CompareReport compared = judged(place, mesh, level);
    CAPTURE(mesh, part, place.extract_report.output.faces, compared.forward.rms,
            compared.backward.rms);
    CHECK(compared.forward.rms <= part * diagonal);
    CHECK(compared.backward.rms <= part * diagonal);
    CHECK(place.extract_report.output.faces < faces);
    faces = place.extract_report.output.faces;
  }
}

}  // namespace

TEST_CASE("levels stay within their error", "[progressive][long]") {
  ProgressivePlace place;
  generate("scan", 60'000, place.directory.file("scan.ply"));
  for (const std::string& mesh : {place.directory.file("scan.ply"), whale(), mountains()})
    check_levels(place, mesh);
}

TEST_CASE("levels of any topology and on a lattice stay within their error", "[progressive]") {
  ProgressivePlace place;
  const std::string mesh = place.directory.file("scan.ply");
  generate("scan", 20'000, mesh);
  ProgressiveOptions options;
  options.topology = Topology::free;
  check_levels(place, mesh, options);
  options.bits = 14;
  check_levels(place, mesh, options);
  for (const Refine cost : {Refine::volume, Refine::importance}) {
    options.refine = cost;
    const std::string file = place.made(mesh, options);
    CHECK(error_of([&] { place.extracted(file, Target::error(1)); }).kind() == ErrorKind::usage);
    CHECK_FALSE(progressive_info(place.context, file).prefixes.front().error);
  }
}

TEST_CASE("levels keep their boundary within one and a half errors", "[progressive]") {
  ProgressivePlace place;
  const std::string mesh = place.directory.file("disc.ply");
  write_file(mesh, ply_of(shapes::disc(200, 50), Numbers::doubles));
  ProgressiveOptions options;
  options.base = 4;
  const std::string file = place.made(mesh, options);
  for (const double error : {0.03, 0.003}) {
    const Shape level = read_shape(place.extracted(file, Target::error(error)));
    const std::vector<Segment> before = border_of(read_shape(mesh)), after = border_of(level);
    CAPTURE(error, level.faces.size());
    CHECK(border_distance(before, after, 50) <= 1.5 * error);
    CHECK(border_distance(after, before, 50) <= 1.5 * error);
    CHECK(level.faces.size() < 20'000);
  }
}

TEST_CASE("an error below what a lattice moves is refused, and a tiny one gives all faces",
          "[progressive]") {
  ProgressivePlace place;
  ProgressiveOptions options;
  const std::string exact = place.made(mountains(), options, "exact.wpm");
  place.extracted(exact, Target::error(1e-12));
  // Flat parts are gone for nothing.
  CHECK(place.extract_report.output.faces <= place.report.output.faces);
  options.bits = 10;
  const std::string lattice = place.made(mountains(), options, "lattice.wpm");
  const double off = place.report.output.position_error;
  CHECK(error_of([&] { place.extracted(lattice, Target::error(off / 2)); }).kind() ==
        ErrorKind::usage);
  place.extracted(lattice, Target::error(1.01 * off));
  CHECK(place.extract_report.output.faces <= place.report.output.faces);
}

}  // namespace winnow::test
