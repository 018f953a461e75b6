// Files as they were found: what other readers take is read, what is no mesh is named.
#include <winnow/error.hpp>
#include <winnow/info.hpp>

#include "meshes.hpp"
#include "support/job.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

struct FoundFile {
  const char* name;
  std::uint64_t faces;
  double area;
  std::size_t notes = 0;
};

}  // namespace

TEST_CASE("files that other readers take are read whole") {
  for (const FoundFile& file :
       std::initializer_list<FoundFile>{{"bom.obj", 192, 600},
                                        {"bom.off", 192, 600},
                                        {"bom.ply", 192, 600},
                                        {"group_ends_in_backslash.obj", 192, 600},
                                        {"usemtl_ends_in_backslash.obj", 192, 600},
                                        {"colours_rgba.obj", 192, 600},
                                        {"end_solid.stl", 48, 6},
                                        {"no_facet_lines.stl", 48, 6},
                                        {"one_line.stl", 192, 600},
                                        {"stl_colours.stl", 192, 600, 1},
                                        {"magic_with_blank.ply", 48, 6},
                                        {"lower_case.off", 192, 600},
                                        {"gz_zero_padding.ply.gz", 1520, 12.501879},
                                        {"pzstd_frames.ply.zst", 28'322, 14209.1561}}) {
    const std::string path = test::large_mesh(std::string("F_faults/") + file.name);
    if (path.empty()) return;
    CAPTURE(path);
    Context context;
    const InfoReport report = info(context, path);
    CHECK(report.faces == file.faces);
    CHECK(report.area == Approx(file.area).epsilon(1e-6));
    CHECK(report.bad_faces.degenerate + report.bad_faces.non_finite +
              report.bad_faces.out_of_range ==
          0);
    CHECK(report.notes.size() == file.notes);
  }
}

TEST_CASE("a pointer that stands for a mesh is named") {
  const std::string path = test::large_mesh("F_faults/lfs_pointer.ply");
  if (path.empty()) return;
  Context context;
  const Error error = test::error_of([&] { info(context, path); });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(std::string(error.what()).find("Git LFS") != std::string::npos);
}

}  // namespace winnow
