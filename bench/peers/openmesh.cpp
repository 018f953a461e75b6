// OpenMesh's decimater with its quadric module as a whole program from file to file, one thread:
//   peer_openmesh IN OUT --faces N|--ratio R
// The reader and the writer are ours; building the half-edge mesh counts as reading. Faces that
// would make it non-manifold are left out, as OpenMesh's own reader does.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <map>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Corner = std::array<float, 3>;

// Numbers of equal corners, by sorting.
std::vector<std::uint32_t> weld(const bench::Array<float>& corners, std::vector<Corner>& places) {
  const std::size_t count = corners.size() / 3;
  const auto place = [&](std::uint32_t i) {
    return bench::load<Corner>(
        reinterpret_cast<const unsigned char*>(corners.data() + 3 * std::size_t{i}));
  };
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(i);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return place(a) < place(b); });
  std::vector<std::uint32_t> number(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || place(order[i]) != places.back()) places.push_back(place(order[i]));
    number[order[i]] = static_cast<std::uint32_t>(places.size() - 1);
  }
  return number;
}

Mesh read(const bench::MeshFile& file) {
  Mesh mesh;
  std::vector<Corner> places;
  std::vector<std::uint32_t> indices;
  if (file.layout().is_ply) {
    const auto xyz = file.read_vertices<float>();
    const auto found = file.read_indices();
    for (std::size_t i = 0; i < xyz.size(); i += 3)
      places.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
    indices.assign(found.data(), found.data() + found.size());
  } else {
    indices = weld(file.read_corners<float>(), places);
  }
  mesh.reserve(places.size(), indices.size() / 2, indices.size() / 3);
  for (const auto& [x, y, z] : places) mesh.add_vertex(Mesh::Point(x, y, z));
  const auto vertex = [](std::uint32_t i) { return OpenMesh::VertexHandle(static_cast<int>(i)); };
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
    if (a != b && a != c && b != c) mesh.add_face(vertex(a), vertex(b), vertex(c));
  }
  return mesh;
}

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: IN OUT --faces N");
  ::omerr().disable();  // a line for every face left out
  bench::Report report;
  bench::Stopwatch watch;
  const bench::MeshFile file(arguments.files()[0]);
  Mesh mesh = read(file);
  report.faces_in = file.layout().faces;
  report.read = watch.lap();

  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  mesh.request_face_normals();
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();  // the face count decides
  decimater.initialize();
  decimater.decimate_to_faces(0, arguments.target_faces(report.faces_in));
  mesh.garbage_collection();
  report.faces_out = mesh.n_faces();
  report.simplify = watch.lap();

  std::vector<float> xyz;
  for (const auto v : mesh.vertices()) {
    for (std::size_t axis = 0; axis < 3; ++axis) xyz.push_back(mesh.point(v)[axis]);
  }
  std::vector<std::uint32_t> indices;
  for (const auto f : mesh.faces()) {
    for (const auto v : mesh.fv_range(f)) indices.push_back(static_cast<std::uint32_t>(v.idx()));
  }
  bench::write_ply(arguments.files()[1], xyz.data(), xyz.size() / 3, indices.data(),
                   report.faces_out);
  report.write = watch.lap();
  report.json().print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("peer_openmesh", [&] {
    run(bench::Arguments(argc, argv, {}, {"--faces", "--ratio"}));
  });
}
