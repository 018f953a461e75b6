#include <winnow/error.hpp>
#include <winnow/stream.hpp>

#include "io/arena.hpp"
#include "run/batch_store.hpp"
#include "run/outputs.hpp"
#include "run/simplify_options.hpp"
#include "run/simplify_source.hpp"

#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace winnow {

namespace {

// Takes all batches, and opens what they become.
template <typename Add>
Input input_of(Job& job, const BatchSource& batches, const SimplifyOptions& options,
               const Add& add) {
  if (!batches) throw Error(ErrorKind::usage, "the source has no function that gives batches");
  BatchStore store(job, options);
  for (;;) {
    MeshView batch;
    if (!batches(batch)) break;
    add(store, batch);
  }
  return Input(job, store.finish());
}

Input open_input(Job& job, const MeshSource& source, const SimplifyOptions& options) {
  struct Opener {
    Job& job;
    const SimplifyOptions& options;

    Input operator()(const std::vector<std::string>& files) const { return Input(job, files); }
    Input operator()(const MeshView& mesh) const { return Input(job, mesh); }
    Input operator()(const BatchSource& batches) const {
      return input_of(job, batches, options,
                      [](BatchStore& store, const MeshView& batch) { store.add(batch); });
    }
    Input operator()(const MeshSource::Triangles& triangles) const {
      return input_of(job, triangles.batches, options,
                      [](BatchStore& store, const MeshView& batch) { store.add_triangles(batch); });
    }
  };
  return std::visit(Opener{job, options}, source.kind());
}

// `maps`: none where they are not wanted in memory.
SimplifyReport simplify_to(Context& context, const MeshSource& source, const MeshSink& sink,
                           const SimplifyOptions& options, std::span<VertexMap> maps) {
  check(options);
  if (!maps.empty() && !options.map.empty())
    throw Error(ErrorKind::usage, "`map` names a file, but the map is wanted in memory");
  const auto* files = std::get_if<std::vector<std::string>>(&source.kind());
  SimplifyOptions asked = options;
  if (files == nullptr) asked.from = Format::automatic;
  Job job(context);
  const Stopwatch watch;
  expect_plan(job, asked);
  Outputs outputs;
  outputs.meshes = open_sinks(job, sink, asked);
  outputs.maps = open_maps(job, asked, outputs.meshes);
  for (VertexMap& map : maps) outputs.maps.push_back(std::make_unique<MapArray>(map));
  Input input = open_input(job, source, asked);
  SimplifyReport report =
      in_arena(job, [&] { return simplify_input(job, std::move(input), outputs, asked, watch); });
  if (files != nullptr) report.input.names = *files;
  return report;
}

}  // namespace

SimplifyReport simplify(Context& context, const MeshSource& source, const MeshSink& sink,
                        const SimplifyOptions& options, VertexMap* map) {
  if (map == nullptr) return simplify_to(context, source, sink, options, {});
  if (!options.coarser.empty())
    throw Error(ErrorKind::usage, "several targets give several maps: pass a vector of VertexMaps");
  return simplify_to(context, source, sink, options, {map, 1});
}

SimplifyReport simplify(Context& context, const MeshSource& source, const MeshSink& sink,
                        const SimplifyOptions& options, std::vector<VertexMap>& maps) {
  maps.assign(1 + options.coarser.size(), {});
  return simplify_to(context, source, sink, options, maps);
}

}  // namespace winnow
