// meshoptimizer as a whole program from file to file, one thread:
//   peer_meshoptimizer IN OUT --faces N|--ratio R [--method sloppy|edges]
// `sloppy` is meshopt_simplifySloppy (vertex clustering), `edges` is meshopt_simplify (edge
// collapse). The library has no file formats, so the reader and the writer are ours. STL is welded
// first, which counts as reading and is shown apart in seconds_weld.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <limits>

#include <meshoptimizer.h>

namespace {

struct Mesh {
  bench::Array<float> xyz;
  bench::Array<std::uint32_t> indices;
};

Mesh weld(const bench::Array<float>& corners) {
  const std::size_t count = corners.size() / 3;
  bench::Array<std::uint32_t> remap(count);
  const std::size_t unique =
      meshopt_generateVertexRemap(remap.data(), nullptr, count, corners.data(), count, 12);
  Mesh mesh{bench::Array<float>(unique * 3), bench::Array<std::uint32_t>(count)};
  meshopt_remapVertexBuffer(mesh.xyz.data(), corners.data(), count, 12, remap.data());
  meshopt_remapIndexBuffer(mesh.indices.data(), nullptr, count, remap.data());
  return mesh;
}

bench::Array<std::uint32_t> simplify(const Mesh& mesh, std::uint64_t faces, bool sloppy) {
  // No error limit: the face count decides. The library asks for room for every input index;
  // untouched pages of it cost nothing.
  const float any_error = std::numeric_limits<float>::max();
  const std::size_t vertices = mesh.xyz.size() / 3;
  bench::Array<std::uint32_t> kept(mesh.indices.size());
  kept.shrink(
      sloppy ? meshopt_simplifySloppy(kept.data(), mesh.indices.data(), mesh.indices.size(),
                                      mesh.xyz.data(), vertices, 12, faces * 3, any_error, nullptr)
             : meshopt_simplify(kept.data(), mesh.indices.data(), mesh.indices.size(),
                                mesh.xyz.data(), vertices, 12, faces * 3, any_error, 0, nullptr));
  return kept;
}

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: IN OUT --faces N");
  const std::string method = arguments.text("--method", "sloppy");
  if (method != "sloppy" && method != "edges")
    throw std::runtime_error("--method is sloppy or edges");

  bench::Report report;
  bench::Stopwatch watch;
  const bench::MeshFile file(arguments.files()[0]);
  Mesh mesh;
  double seconds_weld = 0;
  if (file.layout().is_ply) {
    mesh = {file.read_vertices<float>(), file.read_indices()};
    report.read = watch.lap();
  } else {
    const auto corners = file.read_corners<float>();
    report.read = watch.lap();
    mesh = weld(corners);
    seconds_weld = watch.lap();
    report.read += seconds_weld;
  }
  report.faces_in = file.layout().faces;

  auto kept = simplify(mesh, arguments.target_faces(report.faces_in), method == "sloppy");
  bench::Array<float> xyz(mesh.xyz.size());
  const std::size_t vertices = meshopt_optimizeVertexFetch(
      xyz.data(), kept.data(), kept.size(), mesh.xyz.data(), mesh.xyz.size() / 3, 12);
  report.faces_out = kept.size() / 3;
  report.simplify = watch.lap();

  bench::write_ply(arguments.files()[1], xyz.data(), vertices, kept.data(), report.faces_out);
  report.write = watch.lap();
  report.json().add("seconds_weld", seconds_weld).print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("peer_meshoptimizer", [&] {
    run(bench::Arguments(argc, argv, {}, {"--faces", "--ratio", "--method"}));
  });
}
