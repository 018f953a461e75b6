// Open3D's vertex clustering or edge collapse as a whole program from file to file, with its own
// reader and writer:
//   peer_open3d IN OUT --faces N|--ratio R|--voxel X [--contraction average|quadric]
//   peer_open3d IN OUT --faces N|--ratio R --decimate
// With --faces the voxel is found by trial (see find_cells) outside the reported times, and
// reported, so that a timed run can be given --voxel. STL comes from the reader as a soup, which is
// welded for the collapse, as reading.
#include "peers/driver.hpp"

#include <limits>

#include <open3d/geometry/TriangleMesh.h>
#include <open3d/io/TriangleMeshIO.h>
#include <open3d/utility/Logging.h>

namespace {

using open3d::geometry::TriangleMesh;
using Contraction = TriangleMesh::SimplificationContraction;

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: IN OUT --faces N");
  const std::string name = arguments.text("--contraction", "average");
  if (name != "average" && name != "quadric")
    throw std::runtime_error("--contraction: average or quadric");
  const auto contraction = name == "average" ? Contraction::Average : Contraction::Quadric;
  open3d::utility::SetVerbosityLevel(open3d::utility::VerbosityLevel::Error);

  bench::Report report;
  bench::Stopwatch watch;
  TriangleMesh mesh;
  if (!open3d::io::ReadTriangleMesh(arguments.files()[0], mesh))
    throw std::runtime_error("cannot read");
  report.faces_in = mesh.triangles_.size();
  const bool decimate = arguments.has("--decimate");
  const bool soup =
      mesh.vertices_.size() > mesh.triangles_.size();  // a surface has about half as many
  if (decimate && soup) mesh.RemoveDuplicatedVertices();
  report.read = watch.lap();

  double voxel = arguments.number("--voxel", 0);
  if (voxel == 0 && !decimate) {
    const double side = (mesh.GetMaxBound() - mesh.GetMinBound()).maxCoeff();
    const auto target = static_cast<double>(arguments.target_faces(report.faces_in));
    voxel = side / bench::find_cells(target, [&](double cells) {
              return mesh.SimplifyVertexClustering(side / cells)->triangles_.size();
            });
  }
  const double seconds_search = watch.lap();

  const auto small = decimate ? mesh.SimplifyQuadricDecimation(
                                    static_cast<int>(arguments.target_faces(report.faces_in)),
                                    std::numeric_limits<double>::infinity(), 1.0)
                              : mesh.SimplifyVertexClustering(voxel, contraction);
  report.simplify = watch.lap();
  report.faces_out = small->triangles_.size();
  if (!open3d::io::WriteTriangleMesh(arguments.files()[1], *small))
    throw std::runtime_error("cannot write");
  report.write = watch.lap();
  report.json().add("voxel", voxel).add("seconds_search", seconds_search).print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("peer_open3d", [&] {
    run(bench::Arguments(argc, argv, {"--decimate"},
                         {"--faces", "--ratio", "--voxel", "--contraction"}));
  });
}
