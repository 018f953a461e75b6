// Surfaces of any size, made from nothing: input for tests and benches.
#pragma once

#include <winnow/context.hpp>
#include <winnow/options.hpp>
#include <winnow/simplify.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

namespace winnow {

enum class Surface {
  scan,     // closed and curved, noise at several scales, rows in the order of a scanner
  terrain,  // a height field with a boundary
  part      // like CAD: flat faces, sharp edges, thin walls
};

struct GenerateOptions {
  Surface surface = Surface::scan;
  std::uint64_t faces = 1'000'000;  // the nearest number that the surface's grid allows is made
  std::uint32_t seed = 1;           // another number, another surface of the same kind
  Format to = Format::automatic;    // by the output's name, else PLY; no GLB
  bool shuffle = false;             // faces in a scattered order instead of the scanner's
  std::array<double, 3> offset{0, 0, 0};  // added to every position; PLY is then written in double
  bool force = false;                     // replace an existing output file
};

struct GenerateReport {
  std::string name;    // of the output, as it was given
  std::string format;  // as in SimplifyReport
  std::uint64_t faces = 0, vertices = 0, bytes = 0;
  double seconds = 0;
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, GenerateReport>
void for_each_field(Report& report, Field&& field) {
  field("file", report.name);
  field("format", report.format);
  field("faces", report.faces);
  field("vertices", report.vertices);
  field("bytes", report.bytes);
  field("seconds", report.seconds);
}

// Writes the surface to `output`, a file's name or "-" for standard output, in bounded memory. The
// bytes depend on `options` alone. The surface is about 2 units across; its spacing follows from
// the count. Throws Error: usage (a count that the format cannot hold), resources, cancelled,
// failed.
GenerateReport generate(Context& context, const std::string& output,
                        const GenerateOptions& options);

std::span<const Option<GenerateOptions>> generate_options();

}  // namespace winnow
