#include <winnow/error.hpp>
#include <winnow/mesh.hpp>

#include "io/arena.hpp"
#include "run/map_sink.hpp"
#include "run/mesh_sink.hpp"
#include "run/simplify_options.hpp"
#include "run/simplify_source.hpp"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace winnow {

namespace {

template <typename Source>
SimplifyReport simplify_between(Job& job, const Source& source, const SimplifyOptions& options,
                                VertexMap* map, const std::function<MeshSinks()>& open_sinks) {
  return in_arena(job, [&] {
    const Stopwatch watch;
    expect_plan(job, options);
    const MeshSinks sinks = open_sinks();
    std::unique_ptr<MapSink> map_sink = open_map(job, options, sinks);
    if (map != nullptr) map_sink = std::make_unique<MapArray>(*map);
    return simplify_input(job, Input(job, source), sinks, map_sink.get(), options, watch);
  });
}

template <typename Source>
std::vector<Mesh> simplified_meshes(Context& context, const Source& source,
                                    const SimplifyOptions& options, SimplifyReport* report,
                                    VertexMap* map = nullptr) {
  check(options);
  if (map != nullptr && !options.map.empty())
    throw Error(ErrorKind::usage, "`map` names a file, but the map is wanted in memory");
  Job job(context);
  std::vector<Mesh> results(1 + options.coarser.size());
  SimplifyReport told = simplify_between(job, source, options, map,
                                         [&] { return sinks_into(job, results, options); });
  if (report != nullptr) *report = std::move(told);
  return results;
}

template <typename Source>
Mesh simplified_mesh(Context& context, const Source& source, const SimplifyOptions& options,
                     SimplifyReport* report, VertexMap* map) {
  refuse_levels(options);
  return std::move(simplified_meshes(context, source, options, report, map).front());
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
  return simplified_mesh(context, mesh, options, report, map);
}

Mesh simplify(Context& context, const std::string& input, const SimplifyOptions& options,
              SimplifyReport* report, VertexMap* map) {
  Mesh mesh = simplified_mesh(context, std::vector{input}, options, report, map);
  if (report != nullptr) report->input.names = {input};
  return mesh;
}

std::vector<Mesh> simplify_levels(Context& context, const MeshView& mesh,
                                  const SimplifyOptions& options, SimplifyReport* report) {
  return simplified_meshes(context, mesh, options, report);
}

std::vector<Mesh> simplify_levels(Context& context, const std::string& input,
                                  const SimplifyOptions& options, SimplifyReport* report) {
  std::vector<Mesh> meshes = simplified_meshes(context, std::vector{input}, options, report);
  if (report != nullptr) report->input.names = {input};
  return meshes;
}

SimplifyReport simplify(Context& context, const MeshView& mesh, const std::string& output,
                        const SimplifyOptions& options) {
  check(options);
  Job job(context);
  return simplify_between(job, mesh, options, nullptr,
                          [&] { return sinks_to(job, output, options); });
}

}  // namespace winnow
