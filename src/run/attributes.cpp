#include "run/attributes.hpp"

#include "base/text.hpp"

#include <array>
#include <cmath>

namespace winnow {

namespace {

// Vectors nearer to this length are left as they are, so that equal normals stay what they were.
constexpr double unit_tolerance = 1e-6;

}  // namespace

AttributeWish wish_for(const SimplifyOptions& options, const MeshEncoder& encoder) {
  AttributeWish wish;
  wish.names = options.attributes;
  wish.refusal = [&encoder, normals = options.normals](const Attribute& attribute) -> std::string {
    if (normals && attribute.kind == AttributeKind::normal)
      return "normals of the input, as --normals computes those of the result:";
    return encoder.attribute_refusal(attribute);
  };
  return wish;
}

CarriedAttributes take_attributes(Job& job, MeshReader& reader, SimplifyReport& report) {
  const AttributeChoice& choice = reader.facts().choice;
  CarriedAttributes carried{choice.carried, {}};
  for (const MeshReader::AttributeRange& range : reader.attribute_ranges()) {
    carried.largest.push_back(range.largest);
    report.attributes.ignored += range.not_finite;
  }
  for (const Attribute& attribute : carried.attributes)
    report.attributes.carried.push_back(described(attribute));
  report.attributes.dropped = choice.dropped;
  if (!choice.dropped.empty()) {
    std::string line;
    for (const std::string& what : choice.dropped) line += (line.empty() ? "not carried: " : "; ") + what;
    job.note(line);
  }
  if (report.attributes.ignored > 0) {
    job.note(grouped(report.attributes.ignored) +
             " numbers of carried attributes are not finite; the means leave them out");
  }
  return carried;
}

void finish_attributes(const MeshShape& shape, std::span<double> values, MeshVertex& vertex) {
  const std::vector<Attribute>& attributes = shape.attributes;
  vertex.attributes = values;
  double square = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (attributes[i].kind == AttributeKind::normal) square += values[i] * values[i];
    values[i] = stored_of_mean(attributes[i], values[i]);
  }
  const double length = std::sqrt(square);
  const bool unit = std::abs(length - 1) <= unit_tolerance;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (attributes[i].kind != AttributeKind::normal) continue;
    // nx, ny or nz
    float& along = vertex.normal.at(static_cast<std::size_t>(attributes[i].name[1] - 'x'));
    if (!unit) values[i] = length > 0 ? values[i] / length : double{along};
    if (shape.normals) along = static_cast<float>(values[i]);
  }
}

}  // namespace winnow
