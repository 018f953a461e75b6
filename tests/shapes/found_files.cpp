// Small files on which simplifiers went wrong (F_faults), with what is right for each.
#include "meshes.hpp"
#include "support/notes.hpp"
#include "support/refined_shape.hpp"

#include <algorithm>
#include <set>

namespace winnow::test {

namespace {

struct Found {
  SimplifyReport report;
  Shape input, output;
  AttributedMesh attributed;

  [[nodiscard]] bool notes(const std::string& part) const { return has_note(report.notes, part); }
};

std::string found_file(const std::string& name) {
  return large_mesh("F_faults/" + name);
}

Found simplify_found(const std::vector<std::string>& paths, SimplifyOptions options,
                     unsigned threads = 2) {
  const Directory directory;
  const std::string output = directory.file("out.ply");
  Context context;
  context.threads = threads;
  Found found;
  found.report = simplify(context, paths, output, fitted_where_asked(std::move(options)));
  found.attributed = read_attributed(output);
  found.output = {found.attributed.positions, found.attributed.faces};
  return found;
}

SimplifyOptions on_grid(std::uint64_t cells) {
  SimplifyOptions options;
  options.target = Target::grid(cells);
  return options;
}

SimplifyOptions by_ratio(double ratio) {
  SimplifyOptions options;
  options.target = Target::ratio(ratio);
  return options;
}

}  // namespace

TEST_CASE("found flat files keep their area in few faces") {
  const struct {
    const char* name;
    SimplifyOptions options;
    std::size_t most_faces;
    double area;
  } files[] = {{"zero_area_border_square.ply", to_relative_error(0.001), 2, 1},
               {"polygon_square_16_corners.obj", to_count(4), 4, 1},
               {"polygon_square_16_corners.obj", to_relative_error(0.001), 2, 1},
               {"concave_L.obj", by_ratio(1), 4, 5},
               {"concave_L.obj", to_relative_error(0.001), 4, 5}};
  for (const auto& file : files) {
    const std::string path = found_file(file.name);
    if (path.empty()) return;
    CAPTURE(path);
    const Found found = simplify_found({path}, file.options);
    CHECK(found.output.faces.size() <= file.most_faces);
    CHECK(area(found.output) == Approx(file.area).epsilon(1e-6));
  }
}

TEST_CASE("found cubes become twelve faces of volume one") {
  for (const char* name : {"cube_zero_area_caps_40.ply", "cube_caps_40_rotated.ply"}) {
    const std::string path = found_file(name);
    if (path.empty()) return;
    CAPTURE(path);
    const Found found = simplify_found({path}, to_count(12));
    CHECK(found.output.faces.size() == 12);
    CHECK(found.report.topology.closed);
    REQUIRE(volume(found.output));
    CHECK(*volume(found.output) == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("a found ball keeps its faces, a found pipe its volume, a found strip its length") {
  std::string path = found_file("ball_on_large_flat_ground.ply");
  if (path.empty()) return;
  const Found ball = simplify_found({path}, to_count(1000));
  CHECK(faces_near(ball.output, {0, 0, 0}, 0.6) >= 950);

  path = found_file("pipe_straight_12gon.ply");
  if (path.empty()) return;
  const Found pipe = simplify_found({path}, to_count(200));
  const Found whole = simplify_found({path}, by_ratio(1));
  REQUIRE(volume(pipe.output));
  CHECK(*volume(pipe.output) == Approx(*volume(whole.output)).epsilon(1e-5));

  path = found_file("strip_1_by_0.02.ply");
  if (path.empty()) return;
  const Found strip = simplify_found({path}, to_relative_error(0.01));
  const Found strip_before = simplify_found({path}, by_ratio(1));
  CHECK(strip.output.faces.size() <= 2);
  const Box box = box_of(strip.output);
  const Box before = box_of(strip_before.output);
  const double error = 0.01 * length(before.high - before.low);
  CHECK(length(box.high - box.low) >= length(before.high - before.low) - 2 * 1.5 * error);
}

TEST_CASE("the rim of a found disc stays within its error") {
  const std::string path = found_file("disc_flat.ply");
  if (path.empty()) return;
  const Found disc = simplify_found({path}, to_relative_error(0.01));
  const Found before = simplify_found({path}, by_ratio(1));
  const double error = 0.01 * length(box_of(before.output).high - box_of(before.output).low);
  CHECK(border_distance(border_of(disc.output), border_of(before.output), 100) <= 1.5 * error);
  CHECK(border_distance(border_of(before.output), border_of(disc.output), 100) <= 1.5 * error);
}

TEST_CASE("a found double-sided ball has one side, and a found soup is closed by --weld") {
  std::string path = found_file("double_sided_sphere.stl");
  if (path.empty()) return;
  const Found ball = simplify_found({path}, by_ratio(0.5));
  CHECK(ball.report.merged_opposite_faces == 600);
  const Defects defects = defects_of(ball.output.faces);
  CHECK(defects.discords == 0);
  CHECK(defects.crowded == 0);
  CHECK(ball.notes("once in each sense"));

  path = found_file("soup_jitter_1e-6.stl");
  if (path.empty()) return;
  CHECK(simplify_found({path}, by_ratio(0.5)).notes("`weld`"));
  SimplifyOptions weld = by_ratio(0.5);
  weld.weld = 1e-5;
  CHECK(simplify_found({path}, weld).report.topology.closed);
}

TEST_CASE("a found vertex far away changes nothing that it should not") {
  std::string path = found_file("far_vertex_refine_none.ply");
  if (path.empty()) return;
  SimplifyOptions clustered = to_count(1000);
  clustered.refine = Refine::none;
  const Found far = simplify_found({path}, clustered);
  const std::size_t faces = far.output.faces.size();
  CHECK(((faces >= 900 && faces <= 1100) || !far.report.notes.empty()));

  path = found_file("unreferenced_far_vertex.ply");
  if (path.empty()) return;
  for (const SimplifyOptions& options : {to_relative_error(0.001), on_grid(50)}) {
    const Found loose = simplify_found({path}, options);
    CHECK(loose.output.faces.size() > 100);
    const Box box = box_of(loose.output);
    CHECK(length(box.high - box.low) < 100);
  }

  path = found_file("utm_with_vertex_at_zero.ply");
  if (path.empty()) return;
  const Found one = simplify_found({path}, to_count(4000), 1);
  for (const unsigned threads : {2U, 7U}) {
    const Found more = simplify_found({path}, to_count(4000), threads);
    CHECK(more.output.vertices == one.output.vertices);
    CHECK(more.output.faces == one.output.faces);
  }
}

TEST_CASE("found attributes are what they mean") {
  std::string path = found_file("labels.ply");
  if (path.empty()) return;
  for (const SimplifyOptions& options : {to_count(200), on_grid(12)}) {
    const Found labels = simplify_found({path}, options);
    const std::vector<double>& all = labels.attributed.columns.at("label");
    CHECK(std::set<double>(all.begin(), all.end()) == std::set<double>{3, 7, 11});
  }
  path = found_file("float_colours_255.ply");
  if (path.empty()) return;
  CHECK(simplify_found({path}, to_count(200)).notes("255 was taken for 1"));
  path = found_file("colours_of_some.obj");
  if (path.empty()) return;
  const Found some = simplify_found({path}, by_ratio(0.5));
  CHECK(some.report.attributes.carried.empty());
  CHECK(some.notes("colours of some vertices"));
  path = found_file("colours_named_r_g_b.ply");
  if (path.empty()) return;
  const Found named = simplify_found({path}, to_count(200));
  const std::vector<double>& red = named.attributed.columns.at("r");
  CHECK(std::all_of(red.begin(), red.end(), [&](double value) { return value == 200; }));
}

TEST_CASE("found tiles of doubles and floats are told of and joined by --weld") {
  const std::string doubles = found_file("tile_double.ply");
  const std::string floats = found_file("tile_float.ply");
  if (doubles.empty() || floats.empty()) return;
  const Found apart = simplify_found({doubles, floats}, by_ratio(1));
  CHECK(apart.notes("may not be joined"));
  SimplifyOptions weld = by_ratio(1);
  weld.weld = Distance::of_diagonal(1e-5);
  const Found joined_tiles = simplify_found({doubles, floats}, weld);
  CHECK(joined_tiles.report.topology.output.boundary < apart.report.topology.output.boundary);
}

}  // namespace winnow::test
