// What is in a mesh file, found by streaming it.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/simplify.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

struct InfoReport {
  std::string name;  // of the file, as it was given
  std::string
      format;  // "PLY binary little-endian", "STL ASCII", "OBJ", ... with ", gzip" or ", zstd"
  std::uint64_t bytes = 0;     // after decompression
  std::uint64_t faces = 0;     // triangles, bad ones included; polygons count as their triangles
  std::uint64_t vertices = 0;  // vertices stored; 0 for formats without (STL)
  BadFaces bad_faces;
  std::uint64_t zero_area = 0;  // faces with three distinct corners on one line; they are not bad
  struct Box {
    std::array<double, 3> min{}, max{};
  };
  std::optional<Box> box;               // over all finite vertices, used or not, if there is one
  double area = 0;                      // of all good faces, in model units squared
  double mean_edge = 0;                 // over the edges of all good faces, shared ones twice
  std::vector<std::string> attributes;  // "vertex: nx ny nz (float)", a line each

  // Of the good faces. Vertices at the same position are one, so that formats with and without
  // shared vertices give the same numbers.
  SurfaceEdges edges;
  bool watertight = false;  // there are faces, and every edge has two
  std::uint64_t parts = 0;  // sets of faces that share no vertex with others
  std::optional<double>
      volume;  // enclosed, in model units cubed, below 0 where the faces look inward; only
               // where every side of a face meets one of the opposite direction
  double seconds = 0;
  std::uint64_t spilled_bytes = 0;       // written to scratch
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;
  std::vector<std::string> notes;  // what was unusual about the input, a line each
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, InfoReport>
void for_each_field(Report& report, Field&& field) {
  field("file", report.name);
  field("format", report.format);
  field("bytes", report.bytes);
  field("faces", report.faces);
  field("vertices", report.vertices);
  field("bad_faces", report.bad_faces);
  field("zero_area", report.zero_area);
  field("box", report.box);
  field("area", report.area);
  field("mean_edge", report.mean_edge);
  field("attributes", report.attributes);
  field("edges.total", report.edges.total);
  field("edges.boundary", report.edges.boundary);
  field("edges.non_manifold", report.edges.non_manifold);
  field("watertight", report.watertight);
  field("parts", report.parts);
  field("volume", report.volume);
  field("spilled_bytes", report.spilled_bytes);
  field("peak_scratch_bytes", report.peak_scratch_bytes);
  field("seconds", report.seconds);
  field("peak_memory_bytes", report.peak_memory_bytes);
  field("notes", report.notes);
}

// Reads `input` (a file's name, or "-" for standard input) once, and sorts in scratch what does not
// fit. Throws Error: bad_input, resources, cancelled, failed.
WINNOW_API InfoReport info(Context& context, const std::string& input,
                           Format from = Format::automatic);

}  // namespace winnow
