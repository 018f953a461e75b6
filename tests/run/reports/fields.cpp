// The tables of reports, of which JSON and checkpoints are made, know every field.
#include <winnow/compare.hpp>
#include <winnow/convert.hpp>
#include <winnow/info.hpp>
#include <winnow/progressive.hpp>
#include <winnow/sequence.hpp>
#include <winnow/simplify.hpp>

#include "generate/generate.hpp"
#include "support/field_count.hpp"

#include <set>

namespace winnow::test {

namespace {

// How many places the table of a report has, each of its own.
template <typename Report>
std::size_t places() {
  const Report report;
  std::set<std::string> paths;
  std::size_t visited = 0;
  for_each_field(report, [&](const std::string& path, const auto& /*value*/) {
    paths.insert(path);
    ++visited;
  });
  CHECK(paths.size() == visited);
  return visited;
}

// Fields of structs that count by their own fields instead of as one.
template <typename... Groups>
constexpr std::size_t more_in() {
  return (field_count<Groups>() + ...) - sizeof...(Groups);
}

}  // namespace

TEST_CASE("every field of a report has a place of its own") {
  using Report = SimplifyReport;
  constexpr std::size_t base = 1;
  CHECK(places<Report>() ==
        field_count<Report>() - base +
            more_in<Report::Input, BadFaces, Report::Weld, Report::Attributes, Report::Clustered,
                    Report::Seconds>() +
            field_count<LevelReport>() +
            more_in<LevelReport::Output, LevelReport::Refinement, LevelReport::Fit,
                    LevelReport::Lost, LevelReport::Topology, LevelReport::Area>());
  CHECK(places<SimplifyPlan>() == field_count<SimplifyPlan>());
  CHECK(places<ConvertReport>() ==
        field_count<ConvertReport>() +
            more_in<ConvertReport::Input, ConvertReport::Output, ConvertReport::Attributes,
                    ConvertReport::Seconds>());
  CHECK(places<InfoReport>() == field_count<InfoReport>() + more_in<SurfaceEdges>());
  CHECK(places<ProgressiveReport>() ==
        field_count<ProgressiveReport>() +
            more_in<ProgressiveReport::Input, Report::Weld, ProgressiveReport::Output,
                    Report::Attributes, ProgressiveReport::Seconds>());
  CHECK(places<SequenceReport>() ==
        field_count<SequenceReport>() +
            more_in<SequenceReport::Input, SequenceReport::Output, LevelReport::Lost,
                    LevelReport::Area, SequenceReport::Seconds>());
  CHECK(places<ExtractReport>() ==
        field_count<ExtractReport>() +
            more_in<ExtractReport::Input, ExtractReport::Output, ExtractReport::Attributes,
                    ExtractReport::Seconds>());
  CHECK(places<GenerateReport>() == field_count<GenerateReport>());
  // A distance has a place in model units and one in percent; the worst place has three numbers.
  using Compared = CompareReport;
  CHECK(places<Compared>() ==
        field_count<Compared>() +
            more_in<Compared::Mesh, Compared::Mesh, Distances, Distances, Distances,
                    Compared::Normals, Compared::Topology, Compared::Angles>() +
            3 * field_count<Distances>() + 2);
}

}  // namespace winnow::test
