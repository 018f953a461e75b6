#include <winnow/error.hpp>
#include <winnow/stream.hpp>

#include "io/arena.hpp"
#include "run/batch_store.hpp"
#include "run/map_sink.hpp"
#include "run/result_sink.hpp"
#include "run/simplify_options.hpp"
#include "run/simplify_source.hpp"

#include <memory>
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

}  // namespace

SimplifyReport simplify(Context& context, const MeshSource& source, const MeshSink& sink,
                        const SimplifyOptions& options, VertexMap* map) {
  check(options);
  if (map != nullptr && !options.map.empty())
    throw Error(ErrorKind::usage, "`map` names a file, but the map is wanted in memory");
  const auto* files = std::get_if<std::vector<std::string>>(&source.kind());
  SimplifyOptions asked = options;
  if (files == nullptr) asked.from = Format::automatic;
  Job job(context);
  const Stopwatch watch;
  expect_plan(job, asked);
  const ResultSinks results = open_sinks(job, sink, asked);
  std::unique_ptr<MapSink> map_sink = open_map(job, asked, results);
  if (map != nullptr) map_sink = std::make_unique<MapArray>(*map);
  Input input = open_input(job, source, asked);
  SimplifyReport report = in_arena(job, [&] {
    return simplify_input(job, std::move(input), results, map_sink.get(), asked, watch);
  });
  if (files != nullptr) report.input.names = *files;
  return report;
}

}  // namespace winnow
