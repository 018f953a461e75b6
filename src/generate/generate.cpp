#include <winnow/error.hpp>
#include <winnow/generate.hpp>

#include "base/text.hpp"
#include "generate/stream.hpp"
#include "generate/surface.hpp"
#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

// Says so where single precision would round neighbouring vertices onto each other.
void check_precision(Job& job, const MeshShape& shape, const GenerateOptions& options) {
  float farthest = 0;
  for (const double value : options.offset)
    farthest = std::max(farthest, static_cast<float>(std::abs(value)));
  const double step = std::nextafter(farthest, std::numeric_limits<float>::infinity()) - farthest;
  const double edge = 2 / std::sqrt(static_cast<double>(shape.faces));  // roughly
  if (step * 16 > edge) {
    job.note("STL holds single precision, which steps by " + shortest(step) +
             " at this offset: vertices move, some may fall together; PLY keeps them apart");
  }
}

}  // namespace

GenerateReport generate(Context& context, const std::string& output, const GenerateOptions& options) {
  const Stopwatch clock;
  Job job(context);
  for (const double value : options.offset) {
    if (!std::isfinite(value)) throw Error(ErrorKind::usage, "the offset must be finite");
  }
  const auto surface = make_surface(options);
  const auto encoder = make_encoder(options.to, output);
  MeshShape shape;
  shape.vertices = surface->vertices();
  shape.faces = surface->faces();
  shape.double_positions =
      std::any_of(options.offset.begin(), options.offset.end(), [](double v) { return v != 0; });
  shape.comment = std::string("winnow generate ") + name_of(options.surface) + " --faces " +
                  std::to_string(shape.faces) + " --seed " + std::to_string(options.seed);
  const std::string header = encoder->header(shape);  // refuses what the format cannot count
  if (encoder->needs_corners()) check_precision(job, shape, options);

  ByteSink sink(job, output, options.force);
  sink.write(std::as_bytes(std::span(header)));
  stream_surface(job, {*surface, *encoder, options, shape}, sink);
  sink.finish();

  GenerateReport report;
  report.faces = shape.faces;
  report.vertices = shape.vertices;
  report.bytes = sink.written();
  report.seconds = clock.seconds();
  return report;
}

}  // namespace winnow
