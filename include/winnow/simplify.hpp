// Simplify a triangle mesh of any size in bounded memory.
#pragma once

#include <winnow/context.hpp>
#include <winnow/format.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace winnow {

enum class Placement {
  mean,    // area-weighted mean of the cell's corners: smooth, steady
  quadric  // the point nearest to the planes of the cell's faces: keeps edges and ridges sharp
};

// What is made of the clustered mesh.
enum class Refine {
  none,       // nothing: pure clustering
  quadric,    // collapse edges at the least distance from the planes of the faces they stand for
  volume,     // collapse vertices that cover the least volume
  importance  // collapse what is seen least
};

// Where open borders of the surface go when edges are collapsed.
enum class Borders {
  weigh,  // they resist being moved sideways
  keep    // their vertices stay, all of them
};

// What collapses may do to the topology: whether a surface is closed, its boundaries, its handles.
enum class Topology {
  keep,  // it stays: the result may have more faces than were asked for
  free   // handles and holes may close and parts may come apart, at a price: the count is met
};

// Options that change the result. Exactly one of cell, grid, faces, ratio, error and
// relative_error must be set.
struct SimplifyOptions {
  std::optional<double> cell;         // edge of a cubic grid cell, in the units of the model; > 0
  std::optional<std::uint64_t> grid;  // cells along the longest side of the bounding box; 1 to 2^21
  std::optional<std::uint64_t> faces;  // so many faces; >= 4. Exact if refined, else about
  std::optional<double> ratio;         // the same as a part of the input's faces; in (0, 1]
  // As few faces as there can be with this error, in model units; > 0. It bounds the two-sided RMS
  // distance. No point of a boundary is farther than 1.5 times the error from the other boundary,
  // both ways. Only with Refine::quadric.
  std::optional<double> error;
  std::optional<double>
      relative_error;  // the same as a part of the diagonal of the input's box; in (0, 1)

  // Default: quadric with faces, ratio and error, none with cell and grid (which allow nothing
  // else).
  std::optional<Refine> refine;
  // Faces that clustering leaves for each that is wanted; > 1. Infinite: none are clustered, equal
  // positions are welded and all faces refined; with an error no other number is allowed. Default:
  // 6, and infinite where that would not spare three quarters of the faces, or where the input has
  // no more than 2^20.
  std::optional<double> detail;
  Borders borders = Borders::weigh;
  Topology topology = Topology::keep;
  bool keep_pieces = false;  // no connected piece of the surface goes, however small it is
  double max_normal_deviation =
      45;  // by which one collapse may turn a face, in degrees; in (0, 90]

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
  // OBJ, OFF and GLB normals and colours, STL none. Of several inputs: what all have, of one type.
  std::optional<std::vector<std::string>> attributes;
  // A number that says of an attribute that it has none there: it takes no part in means. Not of
  // colours and normals. Nothing: there is no such number.
  std::optional<double> no_data;
  bool strict = false;  // the first bad face of the input is an error

  // Only the faces all of whose corners lie in this box (its sides included), in model units: its
  // low and its high corner. The others are counted, and neither they nor vertices outside have any
  // influence, but that a number out there may be the largest of its attribute. The lattice of
  // `cell` then hangs on the low corner; `ratio` is of the faces that are left. Default: all faces.
  std::optional<std::array<std::array<double, 3>, 2>> crop;

  // Vertices nearer to each other than this are one, and so are chains of them: in model units; >
  // 0. The first in the order of a space-filling curve keeps its place. It acts on all inputs
  // together, before anything else but `crop`, and reads the faces once more, so a pipe is copied
  // to scratch. Faces that lose a corner are left out and counted. Default: only equal positions
  // are one.
  std::optional<double> weld;
  std::optional<double>
      relative_weld;  // the same as a part of the diagonal of the input's box; in (0, 1)

  Format from = Format::automatic;
  Format to = Format::automatic;
  Encoding encoding;  // how the output is written

  // Replace an existing output file. Without it an existing file is a usage error.
  bool force = false;
};

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

struct SimplifyReport {
  struct {
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
  struct {
    std::uint64_t faces = 0, vertices = 0, bytes = 0;  // bytes: before compression
    std::string name;                                  // as it was given
    std::string format;                                // "PLY binary little-endian", "GLB", ...
    // By which Encoding::quantize moves a position at most, in model units; 0 without.
    double position_error = 0;
  } output;
  struct {
    double distance = 0;         // of SimplifyOptions::weld, in model units; 0 without
    std::uint64_t vertices = 0;  // positions that became one with another
    std::uint64_t faces = 0;     // faces that lost a corner thereby; left out
  } weld;

  std::optional<std::uint64_t> target_faces;  // with faces and ratio
  struct {
    Refine cost = Refine::none;
    std::uint64_t tiles = 0;      // that the mesh was cut into at first
    std::uint64_t collapses = 0;  // edges collapsed
    // The root of the mean squared distance of a vertex from the planes of its faces: the largest
    // of all vertices that were moved, in model units. 0 without Refine::quadric.
    double max_error = 0;
    // "count" or "error"; where the count was missed "topology", "boundaries", "hubs" or "pieces",
    // whichever keeps most of the faces; empty without refinement.
    std::string stopped_by;
  } refine;
  std::optional<bool> target_met;      // with target_faces and refinement
  std::vector<std::string> missed_by;  // all that keep one face in eight or more, if it was not

  // What refinement took away besides details. What clustering joined is not known.
  struct {
    std::uint64_t pieces = 0;   // connected ones that went as a whole
    double piece_area = 0;      // of what was left of these when they went
    std::uint64_t handles = 0;  // of these pieces, and with Topology::free those that closed
    std::uint64_t holes = 0;    // boundary loops that closed: with Topology::free
  } lost;

  struct {
    std::vector<std::string> carried;  // "red (uchar)", in the order of the output
    std::vector<std::string>
        dropped;  // what was not carried, and why: "properties of faces: flags"
    // Numbers that are not finite, or FLT_MAX or DBL_MAX in size: the means leave them out.
    std::uint64_t ignored = 0;
  } attributes;

  struct Topology {
    using Edges = SurfaceEdges;
    // Once equal positions are one; only where nothing is clustered, of at most 2^20 faces.
    std::optional<Edges> input;
    Edges output;
    bool closed = false;  // the output: every side of a face meets one of the opposite direction
  } topology;

  // Whether clustering came first, or alone, and the reason: "--detail full", "few faces", ...
  struct {
    bool first = false;
    std::string reason;
  } clustered;

  struct {
    double input = 0;  // of all good faces
    double output = 0;
  } area;

  double cell_size = 0;     // edge of a cell, in the units of the model; 0 where none was clustered
  std::uint64_t cells = 0;  // cells that any corner fell into
  std::uint64_t split_cells =
      0;  // cells that were split because clustering damaged the surface there
  std::uint64_t turned_faces = 0;  // output faces turned to agree with the surface's normals
  std::uint64_t fused_faces =
      0;  // pairs of opposite faces that fell onto each other and became one
  std::uint64_t clamped_faces =
      0;  // input faces so much larger than a cell that their weight was limited

  // No point of an output vertex's cluster is farther than this from it: the diagonal of a cell.
  // One-sided: output to original. In the units of the model. Refinement goes on from there, with
  // refine.max_error.
  double error_bound = 0;

  std::uint64_t runs = 1;           // times the faces were clustered; 2 where the sample misled
  std::uint64_t spilled_bytes = 0;  // written to scratch, all kinds together
  std::uint64_t peak_scratch_bytes = 0;  // most scratch in use at one time
  std::uint64_t peak_memory_bytes = 0;   // the process's largest resident set so far
  struct {
    double total = 0, read = 0, cluster = 0, refine = 0,
           write = 0;  // read: before the first face is clustered
  } seconds;
  std::vector<std::string> notes;  // what was unusual about the input, a line each

  std::optional<Resumed> resumed;  // where the run went on from a checkpoint
};

// What a run would do, found from the input's header and size alone.
struct SimplifyPlan {
  std::string input_format, output_format;  // as in SimplifyReport
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

// Reads `input`, clusters its vertices on a grid, collapses edges of what comes out until it has
// the faces asked for, writes one mesh to `output`.
//
// input: a file's name, or "-" for standard input, of any Format, plain or in gzip or zstd. output:
// a file's name, or "-" for standard output; compressed where the name ends in .gz or .zst. A
// regular file appears under its name only when it is whole; anything else (a pipe, a device) is
// written straight. The result depends on the input's content and on `options` alone: never on the
// context, on threads, on memory, or on whether a file or a pipe was read.
//
// Throws Error: usage (options), bad_input, resources, cancelled, failed.
SimplifyReport simplify(Context& context, const std::string& input, const std::string& output,
                        const SimplifyOptions& options);

// The same with several inputs as one model, in their order: the faces of one after those of the
// other, in the box of all. Each must be a file; of any formats. One is open at a time, and each is
// read again in each pass.
SimplifyReport simplify(Context& context, const std::vector<std::string>& inputs,
                        const std::string& output, const SimplifyOptions& options);

// The plan of the same call; reads no more than the input's header and writes nothing. Same errors.
SimplifyPlan plan_simplify(Context& context, const std::string& input, const std::string& output,
                           const SimplifyOptions& options);
SimplifyPlan plan_simplify(Context& context, const std::vector<std::string>& inputs,
                           const std::string& output, const SimplifyOptions& options);

}  // namespace winnow
