// The options of what is read act as in simplify().
#include "meshes.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"
#include "support/refined_shape.hpp"

#include <algorithm>

namespace winnow::test {

namespace {

// What of the whole file is extracted, and what simplify() leaves where it refines nothing away.
void check_whole(ProgressivePlace& place, const std::vector<std::string>& inputs,
                 const ProgressiveOptions& options, const SimplifyOptions& alike) {
  const std::string file = place.directory.file("mesh.wpm");
  ProgressiveOptions forced = options;
  forced.force = true;
  place.report = progressive(place.context, inputs, file, forced);
  const std::string whole = place.extracted(file, Target::ratio(1), "whole.ply");
  SimplifyOptions all = alike;
  all.target = Target::ratio(1);
  all.detail = std::numeric_limits<double>::infinity();
  all.force = true;
  const std::string direct = place.directory.file("direct.ply");
  const SimplifyReport report = simplify(place.context, inputs, direct, all);
  CHECK(place.report.input.faces == report.input.faces);
  CHECK(place.report.input.cropped_faces == report.input.cropped_faces);
  CHECK(place.report.weld.vertices == report.weld.vertices);
  const bool same = faces_by_content(welded_input(place.context, whole)) ==
                    faces_by_content(welded_input(place.context, direct));
  CHECK(same);
}

}  // namespace

TEST_CASE("a progressive file of several inputs, cropped and welded", "[progressive]") {
  ProgressivePlace place;
  const std::string scan = place.directory.file("scan.ply"),
                    soup = place.directory.file("soup.stl");
  generate("scan", 10'000, scan);
  generate("terrain", 5'000, soup);
  ProgressiveOptions options;
  options.base = 100;
  check_whole(place, {scan, soup}, options, {});
  SimplifyOptions alike;
  options.crop = alike.crop = {{{-10, -10, 0}, {10, 10, 10}}};
  check_whole(place, {scan, soup}, options, alike);
  CHECK(place.report.input.cropped_faces > 0);
  options.crop = alike.crop = std::nullopt;
  options.weld = alike.weld = Distance::of_diagonal(0.002);
  check_whole(place, {scan, soup}, options, alike);
  CHECK(place.report.weld.vertices > 0);
}

TEST_CASE("all vertices of a boundary stay in the coarsest mesh where that is asked for",
          "[progressive]") {
  ProgressivePlace place;
  const std::string mesh = place.directory.file("disc.ply");
  const Shape disc = as_stored(shapes::disc(80, 20), Numbers::doubles);
  write_file(mesh, ply_of(disc, Numbers::doubles));
  ProgressiveOptions options;
  options.base = 4;
  options.boundary = Boundary::keep;
  const std::string file = place.made(mesh, options);
  const Shape base =
      read_shape(place.extracted(file, Target::faces(place.report.output.base_faces)));
  CHECK(border_of(base).size() == border_of(disc).size());
  REQUIRE_FALSE(place.report.notes.empty());
  CHECK(place.report.notes.back().find("`boundary` weigh") != std::string::npos);
  options.boundary = Boundary::weigh;
  place.made(mesh, options);
  CHECK(place.report.output.base_faces < 80);
}

}  // namespace winnow::test
