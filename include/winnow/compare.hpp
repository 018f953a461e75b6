// How far a simplified mesh is from its original, and what is wrong with it.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/distance.hpp>
#include <winnow/simplify.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow {

// From where the picture shows both meshes. y is up, or z where the box is less than half as high
// in z as it is wide in x and in y. The front is at +z, or at -y where z is up.
enum class View {
  iso,    // from the right, the front and above alike
  front,  // from the front
  top,    // from above
  from,   // from any direction
};

struct CompareOptions {
  std::uint64_t samples = 1'000'000;  // about so many points on each surface, evenly by area
  std::string colored;  // a PLY of the simplified mesh coloured by its distance; empty: none
  std::string picture;  // a PNG of both meshes, coloured by distance; empty: none
  View view = View::iso;
  std::array<double, 3>
      viewer{};  // View::from: the direction from the meshes to the viewer, not 0,0,0
  std::optional<Distance> fail_above;  // the report says whether the symmetric RMS is above it
  bool force = false;                  // replace existing files
  Format from_original = Format::automatic, from_simplified = Format::automatic;
};

// In model units.
struct Distances {
  double mean = 0, rms = 0;  // over the samples
  double max = 0;  // over the samples and all vertices (one-sided Hausdorff distance of those)
};

// 0 where there is no diagonal.
constexpr double percent_of(double diagonal, double length) {
  return diagonal > 0 ? 100 * length / diagonal : 0;
}

struct CompareReport {
  struct Mesh {
    std::string name;              // of the file, as it was given
    std::string format;            // as in InfoReport
    std::uint64_t faces = 0;       // good ones
    BadFaces bad_faces;            // left out of everything else
    double area = 0;               // model units squared
    std::optional<double> volume;  // enclosed; absent where the surface is not closed
    std::uint64_t samples = 0;
  };
  Mesh original, simplified;
  double diagonal = 0;  // of the original's box, for percentages

  struct Limit {
    double length = 0;  // CompareOptions::fail_above, in model units
    bool exceeded = false;
  };
  std::optional<Limit> limit;

  Distances forward;   // from points of the original to the simplified surface
  Distances backward;  // from points of the simplified mesh to the original surface
  Distances
      symmetric;  // mean: of both means; rms: sqrt((forward^2 + backward^2) / 2); max: the larger
  std::array<double, 3> worst{};  // where the largest distance was found

  // Between the normal of the original at its samples and the normal of the nearest simplified
  // face, degrees.
  struct Normals {
    double mean = 0, p95 = 0;  // p95 to a hundredth
  } normal_deviation;

  // Of the simplified mesh; vertices in the same place are one.
  struct Topology {
    std::uint64_t boundary_edges = 0, non_manifold_edges = 0;  // with one face; with more than two
    std::uint64_t flipped = 0;     // opposed to the nearest original normal at four inner points
    std::uint64_t degenerate = 0;  // a repeated corner, or no area
    std::uint64_t duplicate = 0;   // the corners of an earlier face, in any order
    std::uint64_t components = 0;
  } topology;

  // Smallest angle of each face, degrees, over faces that have an area.
  struct Angles {
    double min = 0, mean = 0;
    double below_10 = 0;  // share of the faces with a smaller one, 0..1
  } smallest_angles;

  double area_change = 0;               // (simplified - original) / original
  std::optional<double> volume_change;  // the same; absent unless both are closed
  std::uint64_t peak_memory_bytes = 0;
  double seconds = 0;
  std::vector<std::string> notes;
};

// Calls field(path, value) for every field, in the order of the JSON report.
template <typename Report, typename Field>
requires std::same_as<std::remove_const_t<Report>, CompareReport>
void for_each_field(Report& report, Field&& field) {
  const auto mesh = [&](const std::string& path, auto& of) {
    field(path + ".file", of.name);
    field(path + ".format", of.format);
    field(path + ".faces", of.faces);
    field(path + ".bad_faces", of.bad_faces);
    field(path + ".area", of.area);
    field(path + ".volume", of.volume);
    field(path + ".samples", of.samples);
  };
  mesh("original", report.original);
  mesh("simplified", report.simplified);
  field("diagonal", report.diagonal);
  const auto distances = [&](const std::string& path, auto& of) {
    field(path + ".mean", of.mean);
    field(path + ".rms", of.rms);
    field(path + ".max", of.max);
    field(path + ".mean_percent", percent_of(report.diagonal, of.mean));
    field(path + ".rms_percent", percent_of(report.diagonal, of.rms));
    field(path + ".max_percent", percent_of(report.diagonal, of.max));
  };
  distances("distance.forward", report.forward);
  distances("distance.backward", report.backward);
  distances("distance.symmetric", report.symmetric);
  field("distance.worst.x", report.worst[0]);
  field("distance.worst.y", report.worst[1]);
  field("distance.worst.z", report.worst[2]);
  field("fail_above", report.limit);
  field("normal_deviation.mean", report.normal_deviation.mean);
  field("normal_deviation.p95", report.normal_deviation.p95);
  field("topology.boundary_edges", report.topology.boundary_edges);
  field("topology.non_manifold_edges", report.topology.non_manifold_edges);
  field("topology.flipped", report.topology.flipped);
  field("topology.degenerate", report.topology.degenerate);
  field("topology.duplicate", report.topology.duplicate);
  field("topology.components", report.topology.components);
  field("smallest_angles.min", report.smallest_angles.min);
  field("smallest_angles.mean", report.smallest_angles.mean);
  field("smallest_angles.below_10", report.smallest_angles.below_10);
  field("area_change", report.area_change);
  field("volume_change", report.volume_change);
  field("peak_memory_bytes", report.peak_memory_bytes);
  field("seconds", report.seconds);
  field("notes", report.notes);
}

// Compares in the manner of Metro (Cignoni, Rocchini, Scopigno 1998). `original` is streamed twice
// and may be of any size; `simplified` must fit into the budget, with about 500 bytes a face.
// Either is a file's name; one may be "-" for standard input, which is copied to scratch first. The
// report is the same for every number of threads and every budget. Throws Error: usage, bad_input,
// resources (the message names a budget that is enough), cancelled, failed.
WINNOW_API CompareReport compare(Context& context, const std::string& original,
                                 const std::string& simplified, const CompareOptions& options);

}  // namespace winnow
