// CGAL's edge collapse as a whole program from file to file, one thread:
//   peer_cgal IN OUT --faces N|--ratio R [--cost lindstrom-turk|garland-heckbert]
// Lindstrom-Turk is the library's default. The reader and the writer are ours, as CGAL's are
// text-minded; what it takes to make a half-edge mesh of the file (welding, orienting, cutting
// non-manifold places apart) is the library's and counts as reading.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;
namespace simplification = CGAL::Surface_mesh_simplification;

Mesh read(const bench::MeshFile& file) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> faces(file.layout().faces);
  if (file.layout().is_ply) {
    const auto xyz = file.read_vertices<double>();
    const auto indices = file.read_indices();
    for (std::size_t i = 0; i < xyz.size(); i += 3)
      points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    for (std::size_t f = 0; f < faces.size(); ++f)
      faces[f] = {indices[3 * f], indices[3 * f + 1], indices[3 * f + 2]};
  } else {
    const auto corners = file.read_corners<double>();
    for (std::size_t i = 0; i < corners.size(); i += 3)
      points.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = {3 * f, 3 * f + 1, 3 * f + 2};
    processing::merge_duplicate_points_in_polygon_soup(points, faces);
  }
  if (!processing::is_polygon_soup_a_polygon_mesh(faces))
    processing::orient_polygon_soup(points, faces);
  Mesh mesh;
  processing::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return mesh;
}

// The stop predicate counts edges; a closed mesh has three for two faces.
void simplify(Mesh& mesh, std::uint64_t faces, const std::string& cost) {
  const simplification::Count_stop_predicate<Mesh> stop(
      static_cast<std::size_t>(double(faces) * 1.5));
  if (cost == "lindstrom-turk") {
    simplification::edge_collapse(mesh, stop);
    return;
  }
  const simplification::GarlandHeckbert_policies<Mesh, Kernel> policies(mesh);
  simplification::edge_collapse(
      mesh, stop,
      CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
}

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: IN OUT --faces N");
  const std::string cost = arguments.text("--cost", "lindstrom-turk");
  if (cost != "lindstrom-turk" && cost != "garland-heckbert")
    throw std::runtime_error("--cost is lindstrom-turk or garland-heckbert");
  bench::Report report;
  bench::Stopwatch watch;
  const bench::MeshFile file(arguments.files()[0]);
  Mesh mesh = read(file);
  report.faces_in = file.layout().faces;
  report.read = watch.lap();

  simplify(mesh, arguments.target_faces(report.faces_in), cost);
  mesh.collect_garbage();
  report.faces_out = mesh.number_of_faces();
  report.simplify = watch.lap();

  std::vector<float> xyz;
  for (const auto v : mesh.vertices()) {
    for (int axis = 0; axis < 3; ++axis) xyz.push_back(static_cast<float>(mesh.point(v)[axis]));
  }
  std::vector<std::uint32_t> indices;
  for (const auto f : mesh.faces()) {
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) indices.push_back(v);
  }
  bench::write_ply(arguments.files()[1], xyz.data(), xyz.size() / 3, indices.data(),
                   report.faces_out);
  report.write = watch.lap();
  report.json().print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("peer_cgal", [&] {
    run(bench::Arguments(argc, argv, {}, {"--faces", "--ratio", "--cost"}));
  });
}
