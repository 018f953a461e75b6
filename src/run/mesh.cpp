#include <winnow/mesh.hpp>

#include "io/arena.hpp"
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
                                const std::function<MeshSinks()>& open_sinks) {
  return in_arena(job, [&] {
    const Stopwatch watch;
    expect_plan(job, options);
    return simplify_input(job, Input(job, source), open_sinks(), options, watch);
  });
}

template <typename Source>
std::vector<Mesh> simplified_meshes(Context& context, const Source& source,
                                    const SimplifyOptions& options, SimplifyReport* report) {
  check(options);
  Job job(context);
  std::vector<Mesh> results(1 + options.coarser.size());
  SimplifyReport told =
      simplify_between(job, source, options, [&] { return sinks_into(job, results, options); });
  if (report != nullptr) *report = std::move(told);
  return results;
}

template <typename Source>
Mesh simplified_mesh(Context& context, const Source& source, const SimplifyOptions& options,
                     SimplifyReport* report) {
  refuse_levels(options);
  return std::move(simplified_meshes(context, source, options, report).front());
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
              SimplifyReport* report) {
  return simplified_mesh(context, mesh, options, report);
}

Mesh simplify(Context& context, const std::string& input, const SimplifyOptions& options,
              SimplifyReport* report) {
  Mesh mesh = simplified_mesh(context, std::vector{input}, options, report);
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
  return simplify_between(job, mesh, options, [&] { return sinks_to(job, output, options); });
}

}  // namespace winnow
