// Simplify a mesh that moves: one connectivity for all frames.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/format.hpp>
#include <winnow/mesh.hpp>
#include <winnow/report_fields.hpp>
#include <winnow/simplify_report.hpp>
#include <winnow/target.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

// The planes whose squared distances are what a collapse costs in a frame.
enum class Quadrics {
  memoryless,  // of the faces at both ends as they are then
  accumulated  // of all faces of the input that both ends stand for
};

// Options that change the result. options.hpp has them as a table.
struct SequenceOptions {
  Target target;  // faces or ratio, of each frame; it must be set

  Quadrics quadrics = Quadrics::memoryless;
  // An edge costs the sum of what it costs in each frame, and besides this many times the sum of
  // |cost - mean cost| over the frames; >= 0. With more, faces go where the surface deforms.
  double deformation_weight = 0;
  // The sum counts (1 + this times the edge's feature weight) times; >= 0. Boundaries, sharp edges
  // and edges with three faces in the first and the last frame then stay longer.
  double feature_weight = 0;
  // By which one collapse may turn a face, in degrees; in (0, 90]. A frame that cannot keep it
  // makes the collapse costlier. No face of any frame turns by more than 90.
  double max_normal_deviation = 45;

  // The part of all collapses that follows each frame's own cost, after those that all frames have
  // in common; 0 to 1. With 0 all frames have the same faces.
  double per_frame = 0;

  // Write vertex normals computed from each frame of the result instead of the input's.
  bool normals = false;

  // Passes over samples of each frame's original, at the end: in each the frame's vertices move to
  // where it is nearest to the samples, in the least-squares sense. At most 100.
  std::uint64_t fit = 2;

  Format from = Format::automatic;
  Format to = Format::automatic;
  Encoding encoding;   // how each frame is written
  bool force = false;  // replace existing output files
};

struct SequenceReport {
  struct Input {
    std::vector<std::string> names;  // in the order of the frames
    std::string format;              // of the first, as in InfoReport
    std::uint64_t frames = 0;
    std::uint64_t faces = 0, vertices = 0;  // of one frame
    std::uint64_t bytes = 0;                // of all frames, after decompression
  } input;
  struct Output {
    std::vector<std::string> names;         // in the order of the frames
    std::string format;                     // as in SimplifyReport
    std::uint64_t faces = 0, vertices = 0;  // of one frame, where they differ the most
    std::uint64_t bytes = 0;                // of all frames, before compression
  } output;
  std::uint64_t target_faces = 0;
  bool target_met = false;      // no more faces than that
  std::uint64_t joined = 0;     // vertices that were at one place in every frame and became one
  std::uint64_t bad_faces = 0;  // that repeat a vertex or name none; left out
  std::uint64_t tiles = 0, collapses = 0;  // that all frames have in common
  LevelReport::Lost lost;                  // from all frames; areas are those of the first
  LevelReport::Area area;                  // of the first frame

  std::optional<Resumed> resumed;        // where the run went on from a checkpoint
  std::uint64_t spilled_bytes = 0;       // written to scratch, all kinds together
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;   // the process's largest resident set so far
  struct Seconds {
    double total = 0, read = 0, refine = 0, write = 0;
  } seconds;
  std::vector<std::string> notes;  // what was unusual, a line each
};

// Calls field(path, value) for every field that tells of the result; a checkpoint keeps them.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, SequenceReport>
void for_each_result(Report& report, Field&& field) {
  field("input.files", report.input.names);
  field("input.format", report.input.format);
  field("input.frames", report.input.frames);
  field("input.faces", report.input.faces);
  field("input.vertices", report.input.vertices);
  field("input.bytes", report.input.bytes);
  field("input.bad_faces", report.bad_faces);
  field("output.files", report.output.names);
  field("output.format", report.output.format);
  field("output.faces", report.output.faces);
  field("output.vertices", report.output.vertices);
  field("output.bytes", report.output.bytes);
  field("target_faces", report.target_faces);
  field("target_met", report.target_met);
  field("joined_vertices", report.joined);
  field("refine.tiles", report.tiles);
  field("refine.collapses", report.collapses);
  for_each_lost_field(report, field);
  field("area.input", report.area.input);
  field("area.output", report.area.output);
  field("notes", report.notes);
}

// All of them, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, SequenceReport>
void for_each_field(Report& report, Field&& field) {
  for_each_result(report, field);
  for_each_run_field(report, field);
}

// Gives the frames of a sequence, the first frame first.
class WINNOW_API FrameSource {
 public:
  virtual ~FrameSource() = default;
  // The next frame; its arrays stay as they are until the next call. False behind the last.
  virtual bool next(MeshView& frame) = 0;
};

// Takes the frames of the result, in the same order.
class WINNOW_API FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void take(std::uint64_t frame, Mesh mesh) = 0;
};

// Simplifies all frames alike: each frame of the result has the same faces (but for `per_frame`),
// and positions of its own. An edge is collapsed where that costs least in the sum over frames, to
// the best place of each frame, and only if it turns no face of any frame too far and keeps the
// topology.
//
// inputs: the files of the frames, each of any Format, plain or compressed. Names that differ in
// one number alone are put in the order of that; others are frames in the order given. One glTF
// with morph targets is a sequence by itself: the mesh as it is, then with each target alone.
// output: a file's name with {frame}, which stands for that number as it is written in the input's
// name, or for the number of the frame from 1 on. Or one GLB, in which the frames are morph
// targets, with the animations of the input's, or one that plays all frames. All frames need the
// same vertices and the same faces in the same order. Vertices that are at one place in every frame
// become one. Vertices carry in each frame what has a meaningful mean, the output can hold and all
// frames have, normals as well. Normals are computed where the first frame has some that are not
// carried.
//
// The result depends on the inputs' content and on `options` alone. Throws Error: usage, bad_input
// (also for frames that differ: the message names both files and the first difference), resources,
// cancelled, failed.
WINNOW_API SequenceReport simplify_sequence(Context& context,
                                            const std::vector<std::string>& inputs,
                                            const std::string& output,
                                            const SequenceOptions& options);

// The same from and to memory. Of the options `from`, `to` and `force` have no meaning. Frames that
// were taken stay taken if a later one fails.
WINNOW_API SequenceReport simplify_sequence(Context& context, FrameSource& source, FrameSink& sink,
                                            const SequenceOptions& options);

}  // namespace winnow
