// A mesh of any size as one file that holds all levels of detail: made, looked at, taken apart.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/format.hpp>
#include <winnow/info.hpp>
#include <winnow/mesh.hpp>
#include <winnow/report_fields.hpp>
#include <winnow/simplify.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace winnow {

struct ProgressiveOptions {
  std::uint64_t base = 1000;        // faces of the coarsest mesh, about; at least 4
  Refine refine = Refine::quadric;  // by which collapses are chosen; not none
  // Positions are whole numbers of so many bits, 8 to 24, along the longest side of the box; the
  // report says how far they move at most. Default: all positions come back to the bit.
  std::optional<unsigned> bits;
  // As in SimplifyOptions; attributes as of a PLY. With a weld the levels are of the welded mesh.
  Boundary boundary = Boundary::weigh;
  Topology topology = Topology::keep;
  std::optional<std::vector<std::string>> attributes;
  bool strict = false;  // the first bad face of the input is an error
  std::optional<std::array<std::array<double, 3>, 2>> crop;
  std::optional<Distance> weld;
  Format from = Format::automatic;
  bool force = false;  // replace an existing output file; without it that is a usage error
};

struct ProgressiveReport {
  struct Input {
    std::vector<std::string> names;  // as they were given
    std::string format;              // as in InfoReport
    std::uint64_t faces = 0;         // triangles read, bad ones included
    std::uint64_t vertices = 0;      // vertices stored; 0 for formats without
    std::uint64_t bytes = 0;         // after decompression
    BadFaces bad_faces;
    std::uint64_t cropped_faces = 0;  // as in SimplifyReport
  } input;
  SimplifyReport::Weld weld;
  struct Output {
    std::string name;                                  // as it was given
    std::uint64_t faces = 0, vertices = 0, bytes = 0;  // at full count; bytes: of the file
    std::uint64_t base_faces = 0, base_vertices = 0;   // of the coarsest mesh
    std::uint64_t chunks = 0;
    double position_error = 0;  // by which ProgressiveOptions::bits moves a position at most
  } output;
  SimplifyReport::Attributes attributes;
  Refine cost = Refine::quadric;
  std::uint64_t rounds = 0, collapses = 0;
  std::optional<Resumed> resumed;        // where the run went on from a checkpoint
  std::uint64_t spilled_bytes = 0;       // written to scratch, all kinds together
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;   // the process's largest resident set so far
  struct Seconds {
    double total = 0, read = 0, refine = 0, write = 0;
  } seconds;
  std::vector<std::string> notes;  // what was unusual, a line each
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, ProgressiveReport>
void for_each_field(Report& report, Field&& field) {
  for_each_input_field(report.input, field);
  field("input.bad_faces", report.input.bad_faces);
  field("input.cropped_faces", report.input.cropped_faces);
  field("weld.distance", report.weld.distance);
  field("weld.vertices", report.weld.vertices);
  field("weld.collapsed_faces", report.weld.faces);
  field("output.file", report.output.name);
  field("output.faces", report.output.faces);
  field("output.vertices", report.output.vertices);
  field("output.bytes", report.output.bytes);
  field("output.base_faces", report.output.base_faces);
  field("output.base_vertices", report.output.base_vertices);
  field("output.chunks", report.output.chunks);
  field("output.position_error", report.output.position_error);
  field("attributes.carried", report.attributes.carried);
  field("attributes.dropped", report.attributes.dropped);
  field("attributes.ignored_values", report.attributes.ignored);
  field("refine.cost", report.cost);
  field("refine.rounds", report.rounds);
  field("refine.collapses", report.collapses);
  field("resumed", report.resumed);
  for_each_usage_field(report, field);
  field("notes", report.notes);
}

// Reads `inputs` as one model, as simplify() does, joins equal positions, and writes a file from
// which every count of faces between the base and all can be extracted: docs/progressive_format.md.
// At full count vertices, attributes and faces are those of the welded input, to the bit.
//
// The bytes depend on the inputs' content and on `options` alone. Throws Error: usage, bad_input,
// resources, cancelled, failed.
WINNOW_API ProgressiveReport progressive(Context& context, const std::vector<std::string>& inputs,
                                         const std::string& output,
                                         const ProgressiveOptions& options);

struct ExtractOptions {
  // Faces, a ratio of all faces, or an error: the coarsest level that keeps it, as simplify()
  // would; only of a file of Refine::quadric. It must be set. With an error nothing is unfolded.
  Target target;
  // Leave folded faces as they are. By default vertices are moved a little where faces are flipped,
  // but not at full count.
  bool raw = false;
  bool normals = false;  // write vertex normals, computed from the result
  Format to = Format::automatic;
  Encoding encoding;   // how the output is written
  bool force = false;  // replace an existing output file; without it that is a usage error
};

struct ExtractReport {
  struct Input {
    std::string name;              // as it was given
    std::uint64_t faces = 0;       // that the whole file has
    std::uint64_t bytes_read = 0;  // of the file, the header among them
  } input;
  std::uint64_t target_faces = 0;  // that were asked for, or that keep the error asked for
  struct Output {
    std::string name;                                  // as it was given
    std::string format;                                // as in SimplifyReport
    std::uint64_t faces = 0, vertices = 0, bytes = 0;  // bytes: before compression
    double position_error = 0;                         // as in ConvertReport
  } output;
  struct Attributes {
    std::vector<std::string> carried, dropped;  // as in ConvertReport
  } attributes;
  std::uint64_t spilled_bytes = 0;       // written to scratch
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;   // the process's largest resident set so far
  struct Seconds {
    double total = 0, read = 0, write = 0;
  } seconds;
  std::vector<std::string> notes;  // what was unusual, a line each
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, ExtractReport>
void for_each_field(Report& report, Field&& field) {
  field("input.file", report.input.name);
  field("input.faces", report.input.faces);
  field("input.bytes_read", report.input.bytes_read);
  field("target_faces", report.target_faces);
  for_each_output_field(report.output, field);
  field("attributes.carried", report.attributes.carried);
  field("attributes.dropped", report.attributes.dropped);
  for_each_usage_field(report, field);
  field("notes", report.notes);
}

// Writes the mesh of so many faces, or of one collapse less, to `output`; names, pipes, formats and
// compression as in simplify(). `input` is read no further than the count needs; "-" is standard
// input. The mesh is held in memory, or in scratch where the budget has no room for it. Throws
// Error: usage (fewer faces than the base has, an error below that of ProgressiveOptions::bits, or
// of a file of another cost), bad_input (damaged, or cut short before the count), resources,
// cancelled, failed.
WINNOW_API ExtractReport extract(Context& context, const std::string& input,
                                 const std::string& output, const ExtractOptions& options);
// The same mesh in memory, which does not count in the budget. What chooses a format is a usage
// error.
WINNOW_API Mesh extract(Context& context, const std::string& input, const ExtractOptions& options,
                        ExtractReport* report = nullptr);

// What the header of a progressive file says.
struct ProgressiveInfo {
  std::string name;                                 // as it was given
  std::string format;                               // "progressive mesh, version 2"
  std::uint64_t bytes = 0;                          // of the whole file, as the header has it
  std::uint64_t faces = 0, vertices = 0;            // at full count
  std::uint64_t base_faces = 0, base_vertices = 0;  // of the coarsest mesh
  std::uint64_t chunks = 0;
  Refine cost = Refine::quadric;
  std::string positions;  // "float", "double", "16 bits"
  std::array<double, 3> box_min{}, box_max{};
  std::vector<std::string> attributes;  // "red (uchar)", a line each
  // The first bytes of the file that so many faces need, and the error that these keep, in the
  // units of the model: see ExtractOptions::target. Nothing where none is known.
  struct Prefix {
    std::uint64_t faces = 0, bytes = 0;
    std::optional<double> error{};
  };
  std::vector<Prefix> prefixes;  // the base, then ten times as many each, up to all
  std::vector<std::string> notes;
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, ProgressiveInfo>
void for_each_field(Report& report, Field&& field) {
  field("file", report.name);
  field("format", report.format);
  field("bytes", report.bytes);
  field("faces", report.faces);
  field("vertices", report.vertices);
  field("base_faces", report.base_faces);
  field("base_vertices", report.base_vertices);
  field("chunks", report.chunks);
  field("cost", report.cost);
  field("positions", report.positions);
  field("box.min", report.box_min);
  field("box.max", report.box_max);
  field("attributes", report.attributes);
  field("prefixes", report.prefixes);
  field("notes", report.notes);
}

// Whether a file of this name is there and begins as a progressive one does, not compressed.
WINNOW_API bool is_progressive(const std::string& input);
// Reads no more than the header. Throws Error: bad_input, resources, cancelled.
WINNOW_API ProgressiveInfo progressive_info(Context& context, const std::string& input);
// Of whatever it turns out to be: a mesh or a progressive file, also compressed or in a pipe.
WINNOW_API std::variant<InfoReport, ProgressiveInfo> info_of_any(Context& context,
                                                                 const std::string& input,
                                                                 Format from = Format::automatic);
// Writes `output`, a progressive file of whatever the input is: one of a mesh is made, of which
// `options` tell; one that there is, also compressed or in a pipe, is copied. Throws Error as
// progressive().
WINNOW_API void copy_or_make_progressive(Context& context, const std::string& input,
                                         const std::string& output,
                                         const ProgressiveOptions& options = {});

// A progressive file that is open: goes to any count, up and down, or step by step.
class WINNOW_API ProgressiveMesh {
 public:
  // A regular file, not compressed. Shows the base first. The context must outlive this; its budget
  // holds the mesh and what is remembered to go down again. Throws Error: bad_input, resources,
  // cancelled.
  ProgressiveMesh(Context& context, const std::string& input);
  ~ProgressiveMesh();
  ProgressiveMesh(ProgressiveMesh&&) noexcept;
  ProgressiveMesh& operator=(ProgressiveMesh&&) noexcept;

  [[nodiscard]] std::uint64_t base_face_count() const;
  [[nodiscard]] std::uint64_t full_face_count() const;
  // What is shown now.
  [[nodiscard]] std::uint64_t face_count() const;
  [[nodiscard]] std::uint64_t vertex_count() const;

  // To the most faces that are no more than this; one collapse less at the most. Throws Error:
  // usage (fewer than the base), bad_input (the file is damaged or ends before), resources,
  // cancelled.
  void go_to(std::uint64_t faces);
  // One collapse is taken back; false at full count.
  bool step_forward();
  // The last of these is made again; false at the base.
  bool step_back();

  // What is shown, in numbers of the file: a vertex keeps its number as long as it is there. Some
  // vertices may have no face.
  [[nodiscard]] Mesh mesh() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace winnow
