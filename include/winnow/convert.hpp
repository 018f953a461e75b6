// Change the format of a triangle mesh of any size in bounded memory.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/format.hpp>
#include <winnow/report_fields.hpp>
#include <winnow/simplify.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

struct ConvertOptions {
  Format from = Format::automatic;
  Format to = Format::automatic;
  Encoding encoding;    // how the output is written
  bool strict = false;  // the first bad face of the input is an error
  bool force = false;   // replace an existing output file; without it that is a usage error
};

struct ConvertReport {
  struct Input {
    std::vector<std::string> names;  // the one that was given
    std::string format;              // as in InfoReport
    std::uint64_t faces =
        0;  // triangles read, bad ones included; polygons count as their triangles
    std::uint64_t vertices = 0;  // vertices stored; 0 for formats without (STL)
    std::uint64_t bytes = 0;     // after decompression
    BadFaces bad_faces;
  } input;
  struct Output {
    std::string name;                                  // as it was given
    std::string format;                                // as in SimplifyReport
    std::uint64_t faces = 0, vertices = 0, bytes = 0;  // bytes: before compression
    // By which Encoding::quantize moves a position at most, in model units; 0 without.
    double position_error = 0;
  } output;
  struct Attributes {
    std::vector<std::string> carried;  // "red (uchar)", in the order of the output
    std::vector<std::string>
        dropped;  // what was not carried, and why: "properties of faces: flags"
  } attributes;
  bool welded = false;  // equal positions of an input without vertices became one vertex
  std::uint64_t doubled_faces =
      0;  // of a welded input: faces with the same three vertices as another; left out

  std::uint64_t spilled_bytes = 0;       // written to scratch, all kinds together
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;   // the process's largest resident set so far
  struct Seconds {
    double total = 0, read = 0, write = 0;
  } seconds;
  std::vector<std::string> notes;  // what was unusual about the input, a line each
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, ConvertReport>
void for_each_field(Report& report, Field&& field) {
  for_each_input_field(report.input, field);
  field("input.bad_faces", report.input.bad_faces);
  for_each_output_field(report.output, field);
  field("attributes.carried", report.attributes.carried);
  field("attributes.dropped", report.attributes.dropped);
  field("welded", report.welded);
  field("doubled_faces", report.doubled_faces);
  for_each_usage_field(report, field);
  field("notes", report.notes);
}

// Reads `input`, writes the same mesh to `output`; names, pipes and compression as in simplify().
//
// An input with vertices of its own (PLY) keeps them, all of them, and its faces, in their order;
// polygons become triangles, bad faces are left out. A vertex that is not finite, which no face can
// use, is written as the first that is finite. An input without (STL) gets vertices: equal
// positions become one, in the order of a space-filling curve, and its faces come in the order of
// their lowest vertices, each set of three once. Vertices keep what they carry (normals, colours,
// texture coordinates, any number; at most 16), as far as the output's format holds it; a note
// names what is left.
//
// The bytes depend on the input's content and on `options` alone. Throws Error: usage, bad_input
// (also for an input without a single good face), resources, cancelled, failed.
WINNOW_API ConvertReport convert(Context& context, const std::string& input,
                                 const std::string& output, const ConvertOptions& options);

}  // namespace winnow
