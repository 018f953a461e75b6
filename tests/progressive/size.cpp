// How many bytes a face takes, and how near the levels are to those of runs of their own.
#include <winnow/compare.hpp>

#include "meshes.hpp"
#include "support/program.hpp"
#include "support/progressive.hpp"

namespace winnow::test {

namespace {

double bytes_a_face(ProgressivePlace& place, const std::string& mesh,
                    std::optional<unsigned> bits = {}) {
  ProgressiveOptions options;
  options.bits = bits;
  place.made(mesh, options);
  return static_cast<double>(place.report.output.bytes) /
         static_cast<double>(place.report.output.faces);
}

double rms(Context& context, const std::string& original, const std::string& level) {
  CompareOptions options;
  options.samples = 200'000;
  return compare(context, original, level, options).symmetric.rms;
}

}  // namespace

TEST_CASE("positions of a scan take at most 12 bytes a face, and 6 on a lattice",
          "[progressive][long]") {
  ProgressivePlace place;
  generate("scan", 500'000, place.directory.file("scan.ply"));
  for (const std::string& mesh : {place.directory.file("scan.ply"), whale(), mountains()}) {
    CAPTURE(mesh);
    CHECK(bytes_a_face(place, mesh) <= 12);
    CHECK(bytes_a_face(place, mesh, 16) <= 6);
  }
}

TEST_CASE("levels are as near to the mesh as runs of their own", "[progressive][long]") {
  ProgressivePlace place;
  generate("scan", 300'000, place.directory.file("scan.ply"));
  for (const std::string& mesh : {place.directory.file("scan.ply"), whale()}) {
    ProgressiveOptions options;
    options.base = 100;
    const std::string file = place.made(mesh, options);
    for (const double ratio : {0.5, 0.1, 0.01, 0.001}) {
      place.raw = true;
      const std::string raw = place.extracted(file, Target::ratio(ratio), "raw.ply");
      place.raw = false;
      const std::string level = place.extracted(file, Target::ratio(ratio));
      SimplifyOptions direct;
      direct.target = Target::faces(place.extract_report.target_faces);
      direct.detail = std::numeric_limits<double>::infinity();
      direct.force = true;
      const std::string own = place.directory.file("own.ply");
      simplify(place.context, mesh, own, direct);
      const double of_level = rms(place.context, mesh, level);
      const double of_raw = rms(place.context, mesh, raw);
      const double of_own = rms(place.context, mesh, own);
      CAPTURE(mesh, ratio, of_level, of_raw, of_own);
      CHECK(of_level <= 1.05 * of_own);
      CHECK(of_raw <= 1.05 * of_own);
    }
  }
}

}  // namespace winnow::test
