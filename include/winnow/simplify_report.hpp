// What a run of simplify() or resume() reports.
#pragma once

#include <winnow/costs.hpp>
#include <winnow/report_fields.hpp>
#include <winnow/stopped_by.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

// Faces of an input that cannot take part, by kind. They are counted and left out.
struct BadFaces {
  std::uint64_t degenerate = 0;    // a corner repeated, or fewer than three corners
  std::uint64_t non_finite = 0;    // a corner at infinity or not a number
  std::uint64_t out_of_range = 0;  // an index of no vertex
  [[nodiscard]] std::uint64_t total() const { return degenerate + non_finite + out_of_range; }
  void add(const BadFaces& more) {
    degenerate += more.degenerate;
    non_finite += more.non_finite;
    out_of_range += more.out_of_range;
  }
};

// What had been done when a run went on from a checkpoint (checkpoint.hpp).
struct Resumed {
  bool clustered = false;    // the input was not read again
  std::uint64_t rounds = 0;  // of refinement
  std::uint64_t tiles = 0;   // of the round after those
  bool written = false;      // all was done but to clear the checkpoint away
};

struct SurfaceEdges {
  std::uint64_t total = 0;
  std::uint64_t boundary = 0;      // with one face
  std::uint64_t non_manifold = 0;  // with more than two
};

// What is told of each result.
struct LevelReport {
  struct Output {
    std::uint64_t faces = 0, vertices = 0, bytes = 0;  // bytes: before compression
    std::string name;                                  // as it was given
    std::string format;                                // "PLY binary little-endian", "GLB", ...
    std::string map;                                   // of SimplifyOptions::map; empty without
    // By which Encoding::quantize moves a position at most, in model units; 0 without.
    double position_error = 0;
  } output;
  std::optional<std::uint64_t> target_faces;  // with faces and ratio
  struct Refinement {
    Refine cost = Refine::none;
    std::uint64_t tiles = 0;      // that the mesh was cut into at first
    std::uint64_t collapses = 0;  // edges collapsed
    // The root of the mean squared distance of a vertex from the planes of its faces: the largest
    // of all vertices that were moved, in model units. 0 without Refine::quadric.
    double max_error = 0;
    // Where the count was missed, what keeps most of the faces; nothing without refinement.
    std::optional<StoppedBy> stopped_by;
  } refine;
  // Of SimplifyOptions::fit; zeros without.
  struct Fit {
    std::uint64_t passes = 0;
    std::uint64_t samples = 0;         // of the input that were near the result
    std::uint64_t moved_vertices = 0;  // in all passes together
    // Of the distances of the samples from the result before and after, in model units. After:
    // along the normals of faces on which the samples keep their places.
    double rms_before = 0, rms_after = 0;
  } fit;
  std::optional<bool> target_met;    // with target_faces and refinement
  std::vector<StoppedBy> missed_by;  // all that keep one face in eight or more, if it was not

  // What refinement took away besides details. What clustering joined is not known.
  struct Lost {
    std::uint64_t pieces = 0;   // connected ones that went as a whole
    double piece_area = 0;      // of what was left of these when they went
    std::uint64_t handles = 0;  // of these pieces, and with Topology::free those that closed
    std::uint64_t holes = 0;    // boundary loops that closed: with Topology::free
  } lost;

  struct Topology {
    // Once equal positions are one. Absent where faces were clustered, as counting takes longer;
    // above 2^20 faces, only where the budget has room for all edges. info() counts them always.
    std::optional<SurfaceEdges> input;
    SurfaceEdges output;
    // Connected pieces, as many as the edges are known of; absent where the budget has no room.
    std::optional<std::uint64_t> input_pieces, output_pieces;
    bool closed = false;  // the output: every side of a face meets one of the opposite direction
  } topology;

  struct Area {
    double input = 0;  // of all good faces
    double output = 0;
  } area;
};

// Of several results the finest is told of here, and in `levels` as well.
struct SimplifyReport : LevelReport {
  struct Input {
    std::uint64_t faces =
        0;  // triangles read, bad ones included; polygons count as their triangles
    std::uint64_t vertices = 0;  // vertices stored; 0 for formats without (STL)
    std::uint64_t bytes = 0;     // after decompression
    BadFaces bad_faces;
    std::uint64_t cropped_faces =
        0;               // left out for SimplifyOptions::crop; the others are `faces` less these
    std::string format;  // as in InfoReport; of several inputs joined by "and"
    std::vector<std::string> names;  // as they were given
  } input;
  struct Weld {
    double distance = 0;         // of SimplifyOptions::weld, in model units; 0 without
    std::uint64_t vertices = 0;  // positions that became one with another
    std::uint64_t faces = 0;     // faces that lost a corner thereby; left out
  } weld;

  struct Attributes {
    std::vector<std::string> carried;  // "red (uchar)", in the order of the output
    std::vector<std::string>
        dropped;  // what was not carried, and why: "properties of faces: flags"
    // Numbers that are not finite, or FLT_MAX or DBL_MAX in size: the means leave them out.
    std::uint64_t ignored = 0;
  } attributes;

  // Whether clustering came first, or alone, and the reason: "`detail` full", "few faces", ...
  struct Clustered {
    bool first = false;
    std::string reason;
  } clustered;

  double cell_size = 0;     // edge of a cell, in the units of the model; 0 where none was clustered
  std::uint64_t cells = 0;  // cells that any corner fell into
  std::uint64_t split_cells =
      0;  // cells that were split because clustering damaged the surface there
  std::uint64_t reoriented_faces = 0;  // output faces turned to agree with the surface's normals
  std::uint64_t merged_opposite_faces =
      0;  // pairs of opposite faces that fell onto each other and became one
  std::uint64_t weight_clamped_faces =
      0;  // input faces so much larger than a cell that their weight was limited

  // No point of an output vertex's cluster is farther than this from it: the diagonal of a cell.
  // One-sided: output to original. In the units of the model. Refinement goes on from there, with
  // refine.max_error.
  double error_bound = 0;

  std::uint64_t cluster_passes = 1;  // times the faces were clustered; 2 where the sample misled
  std::uint64_t spilled_bytes = 0;   // written to scratch, all kinds together
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;   // the process's largest resident set so far
  struct Seconds {
    double total = 0, read = 0, cluster = 0, refine = 0,
           write = 0;  // read: before the first face is clustered
  } seconds;
  std::vector<std::string> notes;  // what was unusual about the input, a line each

  std::vector<LevelReport> levels;  // of several results, the finest first; else empty

  std::optional<Resumed> resumed;  // where the run went on from a checkpoint
};

// Calls field(path, value) for every field that tells of one result.
template <typename Report, typename Field>
void for_each_level_field(Report& report, Field&& field) {
  for_each_output_field(report.output, field);
  field("output.map", report.output.map);
  field("target.faces", report.target_faces);
  field("target_met", report.target_met);
  field("missed_by", report.missed_by);
  field("refine.cost", report.refine.cost);
  field("refine.tiles", report.refine.tiles);
  field("refine.collapses", report.refine.collapses);
  field("refine.max_error", report.refine.max_error);
  field("refine.stopped_by", report.refine.stopped_by);
  field("fit.passes", report.fit.passes);
  field("fit.samples", report.fit.samples);
  field("fit.moved_vertices", report.fit.moved_vertices);
  field("fit.rms_before", report.fit.rms_before);
  field("fit.rms_after", report.fit.rms_after);
  for_each_lost_field(report, field);
  field("topology.input", report.topology.input);
  field("topology.output", report.topology.output);
  field("topology.pieces.input", report.topology.input_pieces);
  field("topology.pieces.output", report.topology.output_pieces);
  field("topology.closed", report.topology.closed);
  field("area.input", report.area.input);
  field("area.output", report.area.output);
}

// Calls field(path, value) for every field that tells of the result. The path is the field's place
// in the JSON report; a checkpoint keeps them by the same name.
template <typename Report, typename Field>
void for_each_result(Report& report, Field&& field) {
  for_each_input_field(report.input, field);
  field("input.cropped_faces", report.input.cropped_faces);
  field("input.bad_faces.degenerate", report.input.bad_faces.degenerate);
  field("input.bad_faces.non_finite", report.input.bad_faces.non_finite);
  field("input.bad_faces.out_of_range", report.input.bad_faces.out_of_range);
  for_each_level_field(report, field);
  field("weld.distance", report.weld.distance);
  field("weld.vertices", report.weld.vertices);
  field("weld.collapsed_faces", report.weld.faces);
  field("attributes.carried", report.attributes.carried);
  field("attributes.dropped", report.attributes.dropped);
  field("attributes.ignored_values", report.attributes.ignored);
  field("clustered.first", report.clustered.first);
  field("clustered.reason", report.clustered.reason);
  field("cell_size", report.cell_size);
  field("cells", report.cells);
  field("split_cells", report.split_cells);
  field("reoriented_faces", report.reoriented_faces);
  field("merged_opposite_faces", report.merged_opposite_faces);
  field("weight_clamped_faces", report.weight_clamped_faces);
  field("error_bound", report.error_bound);
  field("cluster_passes", report.cluster_passes);
  field("notes", report.notes);
  field("levels", report.levels);
}

// The same for those that tell of this run of the program.
template <typename Report, typename Field>
void for_each_run_field(Report& report, Field&& field) {
  for_each_usage_field(report, field);
  field("resumed", report.resumed);
}

// All of them, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, SimplifyReport>
void for_each_field(Report& report, Field&& field) {
  for_each_result(report, field);
  for_each_run_field(report, field);
}

}  // namespace winnow
