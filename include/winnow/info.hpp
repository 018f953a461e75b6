// What is in a mesh file, found by streaming it.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/simplify.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace winnow {

struct InfoReport {
  std::string
      format;  // "PLY binary little-endian", "STL ASCII", "OBJ", ... with ", gzip" or ", zstd"
  std::uint64_t bytes = 0;     // after decompression
  std::uint64_t faces = 0;     // triangles, bad ones included; polygons count as their triangles
  std::uint64_t vertices = 0;  // vertices stored; 0 for formats without (STL)
  BadFaces bad_faces;
  std::uint64_t zero_area = 0;  // faces with three distinct corners on one line; they are not bad
  bool has_box = false;         // whether any vertex is finite
  std::array<double, 3> box_min{}, box_max{};  // over all finite vertices, used or not
  double area = 0;                             // of all good faces, in model units squared
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

// Reads `input` (a file's name, or "-" for standard input) once, and sorts in scratch what does not
// fit. Throws Error: bad_input, resources, cancelled, failed.
WINNOW_API InfoReport info(Context& context, const std::string& input,
                           Format from = Format::automatic);

}  // namespace winnow
