// The JSON report and a checkpoint know every field of the report.
#include <winnow/simplify_report.hpp>

#include "support/field_count.hpp"

#include <set>

namespace winnow::test {

TEST_CASE("every field of a report has a place of its own") {
  const SimplifyReport report;
  std::set<std::string> paths;
  std::size_t visited = 0;
  const auto visit = [&](const std::string& path, const auto& /*value*/) {
    paths.insert(path);
    ++visited;
  };
  for_each_result(report, visit);
  for_each_run_field(report, visit);
  CHECK(paths.size() == visited);

  using Report = SimplifyReport;
  // A group counts by its fields, bad faces as a group within the input.
  const std::size_t groups = field_count<Report::Input>() - 1 + field_count<BadFaces>() +
                             field_count<Report::Output>() + field_count<Report::Weld>() +
                             field_count<Report::Refinement>() + field_count<Report::Lost>() +
                             field_count<Report::Attributes>() + field_count<Report::Topology>() +
                             field_count<Report::Clustered>() + field_count<Report::Area>() +
                             field_count<Report::Seconds>();
  constexpr std::size_t group_count = 10;
  CHECK(visited == field_count<Report>() - group_count + groups);
}

}  // namespace winnow::test
