// At full count everything comes back to the bit, whatever the mesh.
#include "meshes.hpp"
#include "support/mesh_arrays.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"

namespace winnow::test {

namespace {

void check_comes_back(const std::string& mesh, const ProgressiveOptions& options = {}) {
  CAPTURE(mesh, facts_of(options.refine).name);
  ProgressivePlace place;
  const std::string file = place.made(mesh, options);
  const Mesh whole = welded_input(place.context, mesh);
  ProgressiveMesh levels(place.context, file);
  CHECK(levels.full_face_count() == whole.face_count());
  CHECK(place.report.output.base_faces == levels.base_face_count());
  levels.go_to(levels.full_face_count());
  CHECK(levels.face_count() == whole.face_count());
  const bool same = faces_by_content(levels.mesh()) == faces_by_content(whole);
  CHECK(same);
  // And through a file.
  const std::string level = place.extracted(file, Target::ratio(1));
  const bool same_file =
      faces_by_content(welded_input(place.context, level)) == faces_by_content(whole);
  CHECK(same_file);
}

}  // namespace

TEST_CASE("all faces come back to the bit, for every cost", "[progressive][long]") {
  for (const Refine cost : {Refine::quadric, Refine::volume, Refine::importance}) {
    ProgressiveOptions options;
    options.refine = cost;
    options.base = 100;
    check_comes_back(mountains(), options);
  }
}

TEST_CASE("all faces of several tiles come back to the bit", "[progressive][long]") {
  const Directory directory;
  generate("scan", 400'000, directory.file("scan.ply"));
  check_comes_back(directory.file("scan.ply"));
  check_comes_back(whale());
}

TEST_CASE("what vertices carry comes back to the bit", "[progressive][attributes]") {
  const Directory directory;
  for (const bool doubles : {false, true}) {
    write_file(directory.file("ball.ply"), ply_of_arrays(ball_arrays(60, doubles, true)));
    check_comes_back(directory.file("ball.ply"));
  }
}

TEST_CASE("meshes of all kinds come back to the bit", "[progressive][long]") {
  for (const char* name :
       {"A_cad/1002_tray_bottom.STL", "A_cad/thingi10k_520644.stl", "A_cad/counter.unitsmm.STL",
        "A_classic/fandisk.off", "A_classic/block.off", "A_classic/tower_holes.obj",
        "A_classic/horse_be_rgb.ply", "A_classic/falconstatue_boundary.obj",
        "B_attributes/laurana_rgba_normals.ply", "B_attributes/colored_airplane.ply",
        "B_attributes/screwdriver_be_confidence.ply", "C_nasty/beetle_nonmanifold.obj",
        "C_nasty/cube_40k_nonmanifold_quads.obj", "C_nasty/manifold__self_intersectA.obj",
        "C_nasty/meshlab__non_manif_hole.ply", "C_nasty/cgal__elephant-with-holes.off",
        "C_nasty/admesh__examples_conveyor.stl", "C_nasty/single_triangle_with_comments.obj"}) {
    const std::string mesh = large_mesh(name);
    if (mesh.empty()) return;
    for (const Topology topology : {Topology::keep, Topology::free}) {
      ProgressiveOptions options;
      options.topology = topology;
      options.base = 50;
      check_comes_back(mesh, options);
    }
  }
}

TEST_CASE("on a lattice no position moves by more than half a step", "[progressive]") {
  ProgressivePlace place;
  ProgressiveOptions options;
  options.bits = 12;
  const std::string file = place.made(mountains(), options);
  const Mesh whole = welded_input(place.context, mountains());
  ProgressiveMesh levels(place.context, file);
  levels.go_to(levels.full_face_count());
  const Mesh mesh = levels.mesh();
  CHECK(mesh.face_count() == whole.face_count());
  CHECK(mesh.vertex_count() == whole.vertex_count());
  // Sorted by a coordinate they are one another's neighbours still.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto column = [axis](const Mesh& of) {
      std::vector<float> numbers;
      const auto& positions = std::get<std::vector<float>>(of.positions);
      for (std::size_t i = axis; i < positions.size(); i += 3) numbers.push_back(positions[i]);
      std::sort(numbers.begin(), numbers.end());
      return numbers;
    };
    const std::vector<float> before = column(whole), after = column(mesh);
    double farthest = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      farthest = std::max(farthest, std::abs(double{before[i]} - double{after[i]}));
    CHECK(farthest <= place.report.output.position_error);
    CHECK(farthest > 0);
  }
}

TEST_CASE("a note tells of a lattice that is coarse beside the edges", "[progressive]") {
  ProgressivePlace place;
  for (const unsigned bits : {8U, 16U}) {
    ProgressiveOptions options;
    options.bits = bits;
    place.made(mountains(), options);
    const auto& notes = place.report.notes;
    const bool told = std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("more bits keep them apart") != std::string::npos;
    });
    CHECK(told == (bits == 8));
  }
}

}  // namespace winnow::test
