// What is added is stored, and then takes the usual pipeline.
#include <winnow/error.hpp>
#include <winnow/simplification.hpp>
#include <winnow/stream.hpp>

#include "io/arena.hpp"
#include "run/batch_store.hpp"
#include "run/outputs.hpp"
#include "run/simplify_options.hpp"
#include "run/simplify_source.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace winnow {

namespace {

SimplifyOptions checked(SimplifyOptions options) {
  check(options);
  options.from = Format::automatic;
  return options;
}

}  // namespace

struct Simplification::State {
  // `path`: of a file; nothing for memory.
  State(Context& context, const std::optional<std::string>& path, const SimplifyOptions& asked)
      : options(checked(asked)), job(context) {
    expect_plan(job, options);
    outputs.meshes = open_sinks(job, path ? MeshSink(*path) : MeshSink(results), options);
    outputs.maps = open_maps(job, options, outputs.meshes);
    store = std::make_unique<BatchStore>(job, options);
  }

  SimplifyReport finish() {
    const Stopwatch watch;
    Input input(job, store->finish());
    return in_arena(job,
                    [&] { return simplify_input(job, std::move(input), outputs, options, watch); });
  }

  SimplifyOptions options;
  Job job;
  std::vector<Mesh> results;
  Outputs outputs;
  std::unique_ptr<BatchStore> store;
};

Simplification::Simplification(Context& context, const std::string& output,
                               const SimplifyOptions& options)
    : state_(std::make_unique<State>(context, output, options)) {}

Simplification::Simplification(Context& context, const SimplifyOptions& options)
    : state_(std::make_unique<State>(context, std::nullopt, options)) {}

Simplification::~Simplification() = default;

void Simplification::add(const MeshView& batch) {
  state_->store->add(batch);
}

void Simplification::add_triangles(const MeshView& batch) {
  state_->store->add_triangles(batch);
}

namespace {

template <typename Real>
MeshView checked_positions(std::span<const Real> coordinates, std::size_t numbers,
                           const char* message) {
  if (coordinates.size() % numbers != 0) throw Error(ErrorKind::usage, message);
  MeshView view;
  view.positions = coordinates;
  return view;
}

constexpr const char* vertex_takes = "a vertex takes three coordinates";
constexpr const char* triangle_takes = "a triangle takes nine coordinates";

}  // namespace

void Simplification::add_vertices(std::span<const float> coordinates) {
  add(checked_positions(coordinates, 3, vertex_takes));
}

void Simplification::add_vertices(std::span<const double> coordinates) {
  add(checked_positions(coordinates, 3, vertex_takes));
}

void Simplification::add_faces(std::span<const std::uint32_t> corners) {
  if (corners.size() % 3 != 0) throw Error(ErrorKind::usage, "a face takes three vertices");
  MeshView view;
  view.faces = corners;
  add(view);
}

void Simplification::add_triangles(std::span<const float> coordinates) {
  add_triangles(checked_positions(coordinates, 9, triangle_takes));
}

void Simplification::add_triangles(std::span<const double> coordinates) {
  add_triangles(checked_positions(coordinates, 9, triangle_takes));
}

SimplifyReport Simplification::finish() {
  if (state_->outputs.meshes.front()->name().empty())
    throw Error(ErrorKind::usage, "no output was named; finish_mesh() gives the mesh");
  return state_->finish();
}

std::vector<Mesh> Simplification::finish_meshes(SimplifyReport* report) {
  if (!state_->outputs.meshes.front()->name().empty())
    throw Error(ErrorKind::usage, "the mesh goes to a file; finish() writes it");
  SimplifyReport told = state_->finish();
  if (report != nullptr) *report = std::move(told);
  return std::move(state_->results);
}

Mesh Simplification::finish_mesh(SimplifyReport* report) {
  refuse_levels(state_->options);
  return std::move(finish_meshes(report).front());
}

}  // namespace winnow
