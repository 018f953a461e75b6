#include "generate/generate.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "generate/stream.hpp"
#include "generate/surface.hpp"
#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "write/coarse_floats.hpp"
#include "write/formats.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

const char* name_of(Surface surface) {
  switch (surface) {
    case Surface::scan:
      return "scan";
    case Surface::terrain:
      return "terrain";
    case Surface::part:
      return "part";
  }
  return "";
}

// Every surface is about two units across.
Box box_about(const Point& offset) {
  Box box;
  box.add(offset - Point{1, 1, 1});
  box.add(offset + Point{1, 1, 1});
  return box;
}

}  // namespace

GenerateReport generate(Context& context, const std::string& output,
                        const GenerateOptions& options) {
  const Stopwatch clock;
  Job job(context);
  for (const double value : options.offset) {
    if (!std::isfinite(value)) throw Error(ErrorKind::usage, "the offset must be finite");
  }
  const auto surface = make_surface(options);
  const auto encoder = make_encoder(options.to, output);
  if (encoder->needs_survey()) {
    throw Error(ErrorKind::usage,
                "a GLB begins with its box, which is not known before the surface is made; "
                "generate a PLY, and `convert` makes a GLB of it");
  }
  MeshShape shape;
  shape.vertices = surface->vertices();
  shape.faces = surface->faces();
  shape.double_positions =
      std::any_of(options.offset.begin(), options.offset.end(), [](double v) { return v != 0; });
  shape.comment = std::string("winnow generate ") + name_of(options.surface) + " --faces " +
                  std::to_string(shape.faces) + " --seed " + std::to_string(options.seed);
  const std::string header = encoder->header(shape);  // refuses what the format cannot count
  if (!encoder->holds_doubles()) check_floats(box_about(options.offset));
  if (!encoder->holds_doubles()) note_coarse_floats(job, box_about(options.offset), shape.faces);

  ByteSink sink(job, output, options.force);
  if (!writes_text(options.to, output)) sink.refuse_terminal();
  sink.write(std::as_bytes(std::span(header)));
  stream_surface(job, {*surface, *encoder, options, shape}, sink);
  sink.finish();

  GenerateReport report;
  report.name = output;
  report.faces = shape.faces;
  report.vertices = shape.vertices;
  report.bytes = sink.written();
  report.format = format_written(options.to, output);
  report.seconds = clock.seconds();
  return report;
}

}  // namespace winnow
