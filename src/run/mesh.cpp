#include <winnow/mesh.hpp>
#include <winnow/stream.hpp>

#include <utility>
#include <variant>
#include <vector>

namespace winnow {

namespace {

template <typename Result, typename... Map>
Result simplified(Context& context, const MeshSource& source, const SimplifyOptions& options,
                  SimplifyReport* report, Map&&... map) {
  Result result;
  SimplifyReport told = simplify(context, source, MeshSink(result), options, map...);
  if (report != nullptr) *report = std::move(told);
  return result;
}

std::vector<Mesh> levels(Context& context, const MeshSource& source, const SimplifyOptions& options,
                         SimplifyReport* report, std::vector<VertexMap>* maps) {
  using Meshes = std::vector<Mesh>;
  return maps == nullptr ? simplified<Meshes>(context, source, options, report)
                         : simplified<Meshes>(context, source, options, report, *maps);
}

}  // namespace

std::uint64_t Mesh::vertex_count() const {
  return std::visit([](const auto& numbers) { return numbers.size() / 3; }, positions);
}

MeshView Mesh::view() const {
  MeshView view;
  std::visit([&](const auto& numbers) { view.positions = numbers; }, positions);
  view.faces = faces;
  for (const Attribute& attribute : attributes) {
    std::visit(
        [&](const auto& values) {
          view.attributes.push_back({attribute.name, values});
        },
        attribute.values);
  }
  return view;
}

Mesh simplify(Context& context, const MeshView& mesh, const SimplifyOptions& options,
              SimplifyReport* report, VertexMap* map) {
  return simplified<Mesh>(context, MeshSource(mesh), options, report, map);
}

Mesh simplify(Context& context, const std::string& input, const SimplifyOptions& options,
              SimplifyReport* report, VertexMap* map) {
  return simplified<Mesh>(context, MeshSource(input), options, report, map);
}

std::vector<Mesh> simplify_levels(Context& context, const MeshView& mesh,
                                  const SimplifyOptions& options, SimplifyReport* report,
                                  std::vector<VertexMap>* maps) {
  return levels(context, MeshSource(mesh), options, report, maps);
}

std::vector<Mesh> simplify_levels(Context& context, const std::string& input,
                                  const SimplifyOptions& options, SimplifyReport* report,
                                  std::vector<VertexMap>* maps) {
  return levels(context, MeshSource(input), options, report, maps);
}

SimplifyReport simplify(Context& context, const MeshView& mesh, const std::string& output,
                        const SimplifyOptions& options) {
  return simplify(context, MeshSource(mesh), MeshSink(output), options);
}

}  // namespace winnow
