#include <winnow/mesh.hpp>
#include <winnow/stream.hpp>

#include <utility>
#include <variant>
#include <vector>

namespace winnow {

namespace {

template <typename Result>
Result simplified(Context& context, const MeshSource& source, const SimplifyOptions& options,
                  SimplifyReport* report, VertexMap* map = nullptr) {
  Result result;
  SimplifyReport told = simplify(context, source, MeshSink(result), options, map);
  if (report != nullptr) *report = std::move(told);
  return result;
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
                                  const SimplifyOptions& options, SimplifyReport* report) {
  return simplified<std::vector<Mesh>>(context, MeshSource(mesh), options, report);
}

std::vector<Mesh> simplify_levels(Context& context, const std::string& input,
                                  const SimplifyOptions& options, SimplifyReport* report) {
  return simplified<std::vector<Mesh>>(context, MeshSource(input), options, report);
}

SimplifyReport simplify(Context& context, const MeshView& mesh, const std::string& output,
                        const SimplifyOptions& options) {
  return simplify(context, MeshSource(mesh), MeshSink(output), options);
}

}  // namespace winnow
