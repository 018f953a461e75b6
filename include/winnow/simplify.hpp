// Simplify a triangle mesh of any size in bounded memory.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/distance.hpp>
#include <winnow/format.hpp>
#include <winnow/simplify_report.hpp>
#include <winnow/target.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

enum class Placement {
  mean,    // area-weighted mean of the cell's corners: smooth, steady
  quadric  // the point nearest to the planes of the cell's faces: keeps edges and ridges sharp
};

// Where the boundary of the surface goes when edges are collapsed.
enum class Boundary {
  weigh,  // it resists being moved sideways
  keep    // its vertices stay, all of them
};

// What collapses may do to the topology: whether a surface is closed, its boundaries, its handles.
enum class Topology {
  keep,  // it stays: the result may have more faces than were asked for
  free   // handles and holes may close and parts may come apart, at a cost: the count is met
};

// Options that change the result. options.hpp has them as a table.
struct SimplifyOptions {
  Target target;  // how fine; it must be set: options.target = Target::faces(100'000)
  // Further results of the same run, which reads the input once for all: targets of the same kind,
  // faces, ratio or error, each coarser than the one before it. Only refined.
  std::vector<Target> coarser{};

  // Default: quadric for a target of faces, ratio or error, none for cell and grid (which allow
  // nothing else).
  std::optional<Refine> refine;
  // Faces that clustering leaves for each that is wanted; > 1. Infinite: none are clustered, equal
  // positions are welded and all faces refined; with an error no other number is allowed. Default:
  // 6, and infinite where that would not spare three quarters of the faces, or where the input has
  // no more than 2^20.
  std::optional<double> detail;
  Boundary boundary = Boundary::weigh;
  Topology topology = Topology::keep;
  // No connected piece of the surface goes, however small it is; all faces are refined then.
  bool keep_pieces = false;
  double max_normal_deviation =
      45;  // by which one collapse may turn a face, in degrees; in (0, 90]
  // Passes over samples of the original, at the end: in each the vertices move to where the result
  // is nearest to the samples, in the least-squares sense. Boundaries stay, and what is exact stays
  // so. At most 100; only for a target of faces or ratio and Refine::quadric. Default: 0.
  std::optional<std::uint64_t> fit;

  Placement placement = Placement::quadric;  // where in its cell the vertex goes
  bool normals = false;  // write vertex normals, computed from the result; those of the input are
                         // not carried then
  // What vertices carry besides: properties of the input by name, at most 16; "normals" stands for
  // nx, ny and nz, "colors" for red, green, blue and alpha. Nothing: all whose means say something
  // and that the output's format can hold (the report tells which not). Empty: none. Names and
  // types stay; means are weighted by area, colours (as sRGB has them) averaged in linear light. A
  // PLY may have any; an OBJ has red, green and blue (float, from 0 to 1), an OFF also alpha and
  // normals, its colours uchar or float, a glTF the same, its colours uchar, ushort or float: its
  // NORMAL and COLOR_0, which is of light and becomes a colour in other formats. PLY holds all,
  // OBJ, OFF, .m and GLB normals and colours, STL none. Of several inputs: what all have, of one
  // type.
  std::optional<std::vector<std::string>> attributes;
  // A number that says of an attribute that it has none there: it takes no part in means. Not of
  // colours and normals. Nothing: there is no such number.
  std::optional<double> nodata;
  bool strict = false;  // the first bad face of the input is an error

  // Only the faces all of whose corners lie in this box (its sides included), in model units: its
  // low and its high corner. The others are counted, and neither they nor vertices outside have any
  // influence, but that a number out there may be the largest of its attribute. The lattice of
  // `cell` then hangs on the low corner; `ratio` is of the faces that are left. Default: all faces.
  std::optional<std::array<std::array<double, 3>, 2>> crop;

  // Vertices nearer to each other than this are one, and so are chains of them; limits as of
  // `error`. The first in the order of a space-filling curve keeps its place. It acts on all inputs
  // together, before anything else but `crop`, and reads the faces once more, so a pipe is copied
  // to scratch. Faces that lose a corner are left out and counted. Default: only equal positions
  // are one.
  std::optional<Distance> weld;

  Format from = Format::automatic;
  Format to = Format::automatic;
  Encoding encoding;  // how the output is written

  // A file for the VertexMap (below), as an array of NumPy (.npy): a header that tells the count,
  // and a little-endian int64 a vertex. Compressed where the name ends in .gz or .zst. Not for an
  // output whose vertices are not numbered as the map says: STL, and a GLB of Compression::meshopt.
  // With several targets there is one for each, named as the outputs are ("map-{faces}.npy"). A
  // pipe is copied to scratch. Default: none.
  std::string map;

  // Replace an existing output file. Without it an existing file is a usage error.
  bool force = false;
};

// What a run would do, found from the input's header and size alone.
struct SimplifyPlan {
  std::vector<std::string> inputs;          // as they were given
  std::string output;                       // as it was given
  std::string input_format, output_format;  // as in SimplifyReport
  std::vector<std::string> outputs;         // names, the finest first
  std::vector<std::string> maps;            // likewise, of SimplifyOptions::map
  struct Part {
    std::string name;
    std::uint64_t bytes = 0;
  };
  std::vector<Part> memory;           // how the budget is divided
  std::uint64_t smallest_memory = 0;  // the smallest budget that works for this input
  std::vector<std::string> passes;    // what is read, in order
  std::optional<bool> clustered;      // first, or alone; nothing where that shows later
  std::string clustered_reason;
  std::optional<std::uint64_t> faces;  // what the header promises, where it does
  std::optional<std::uint64_t> vertices;
  std::optional<std::uint64_t> scratch_worst;  // no input of this size needs more scratch, in bytes
  // Of a coherent scan, without what a checkpoint keeps; with `cell` or `grid`, which tell no
  // count, as if at a tenth of its faces. Nothing, and no seconds, where an error says how far to
  // go.
  std::optional<std::uint64_t> scratch_expected;
  std::optional<double> seconds_expected;  // a rough guess, from rates measured once
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Plan, typename Field>
requires std::same_as<std::remove_const_t<Plan>, SimplifyPlan>
void for_each_field(Plan& plan, Field&& field) {
  field("input.files", plan.inputs);
  field("input.format", plan.input_format);
  field("output.file", plan.output);
  field("output.format", plan.output_format);
  field("outputs", plan.outputs);
  field("maps", plan.maps);
  field("memory", plan.memory);
  field("smallest_memory", plan.smallest_memory);
  field("passes", plan.passes);
  field("clustered.first", plan.clustered);
  field("clustered.reason", plan.clustered_reason);
  field("faces", plan.faces);
  field("vertices", plan.vertices);
  field("scratch_worst", plan.scratch_worst);
  field("scratch_expected", plan.scratch_expected);
  field("seconds_expected", plan.seconds_expected);
}

// For each vertex of the input, in its order, the number of the output vertex that it became a part
// of; -1 where that part of the surface went, or no good face has the vertex. Vertices of several
// inputs follow each other. In an input without vertices of its own (STL) each face has three, its
// corners. Every vertex of the output has one of the input at least.
//
// With cells alone a vertex went to the one of its cell. Equal positions went the same way, and so
// did near ones that `weld` joined. A vertex that was collapsed went to what the other end of its
// edge became.
using VertexMap = std::vector<std::int64_t>;

// Reads `input`, clusters its vertices on a grid, collapses edges of what comes out until it has
// the faces asked for, writes one mesh to `output`.
//
// input: a file's name, or "-" for standard input, of any Format, plain or in gzip or zstd. output:
// a file's name, or "-" for standard output; compressed where the name ends in .gz or .zst. A
// regular file appears under its name only when it is whole; anything else (a pipe, a device) is
// written straight. {faces}, {ratio} or {error} in the name stands for what the target asks for, as
// a number ("small-{faces}.ply"). With several targets there are as many files, which appear
// together, and their names must differ. The result depends on the input's content and on `options`
// alone: never on the context, on threads, on memory, or on whether a file or a pipe was read.
//
// Throws Error: usage (options), bad_input, resources, cancelled, failed.
WINNOW_API SimplifyReport simplify(Context& context, const std::string& input,
                                   const std::string& output, const SimplifyOptions& options);

// The same with several inputs as one model, in their order: the faces of one after those of the
// other, in the box of all. Each must be a file; of any formats. One is open at a time, and each is
// read again in each pass.
WINNOW_API SimplifyReport simplify(Context& context, const std::vector<std::string>& inputs,
                                   const std::string& output, const SimplifyOptions& options);

// The plan of the same call; reads no more than the input's header and writes nothing. Same errors.
WINNOW_API SimplifyPlan plan_simplify(Context& context, const std::string& input,
                                      const std::string& output, const SimplifyOptions& options);
WINNOW_API SimplifyPlan plan_simplify(Context& context, const std::vector<std::string>& inputs,
                                      const std::string& output, const SimplifyOptions& options);

}  // namespace winnow
