#include "run/attributes.hpp"

#include "base/text.hpp"

#include <array>
#include <cmath>

namespace winnow {

namespace {

// Vectors nearer to this length are left as they are, so that equal normals stay what they were.
constexpr double unit_tolerance = 1e-6;

// From the attributes, where the shape has a normal besides and they have one.
void take_normal(const MeshShape& shape, MeshVertex& vertex) {
  for (std::size_t i = 0; i < shape.attributes.size() && shape.normals; ++i) {
    const Attribute& attribute = shape.attributes[i];
    if (attribute.kind != AttributeKind::normal) continue;
    const auto along = static_cast<float>(vertex.attributes[i]);
    vertex.normal.at(axis_of_normal(attribute)) = std::isfinite(along) ? along : 0;
  }
}

}  // namespace

AttributeWish wish_for(const SimplifyOptions& options, const MeshEncoder& encoder) {
  AttributeWish wish;
  wish.names = options.attributes;
  wish.refusal = [&encoder, normals = options.normals](const Attribute& attribute,
                                                       std::span<const Attribute> wanted) -> std::string {
    if (normals && names_normal(attribute))
      return "normals of the input, as --normals computes those of the result:";
    return encoder.attribute_refusal(attribute, wanted);
  };
  return wish;
}

std::vector<std::string> descriptions(const AttributeChoice& choice) {
  std::vector<std::string> lines;
  for (const Attribute& attribute : choice.carried) lines.push_back(described(attribute));
  return lines;
}

void note_dropped(Job& job, const AttributeChoice& choice) {
  std::string line;
  for (const std::string& what : choice.dropped) line += (line.empty() ? "not carried: " : "; ") + what;
  if (!line.empty()) job.note(line);
}

CarriedAttributes take_attributes(Job& job, MeshReader& reader, SimplifyReport& report) {
  const AttributeChoice& choice = reader.facts().choice;
  CarriedAttributes carried{choice.carried, {}};
  for (const MeshReader::AttributeRange& range : reader.attribute_ranges()) {
    carried.largest.push_back(range.largest);
    report.attributes.ignored += range.without;
  }
  report.attributes.carried = descriptions(choice);
  report.attributes.dropped = choice.dropped;
  note_dropped(job, choice);
  if (report.attributes.ignored > 0) {
    job.note(grouped(report.attributes.ignored) +
             " numbers of carried attributes are not finite, or the largest of their type; the means leave "
             "them out");
  }
  return carried;
}

void finish_attributes(const MeshShape& shape, std::span<double> values, MeshVertex& vertex) {
  const std::vector<Attribute>& attributes = shape.attributes;
  vertex.attributes = values;
  if (shape.as_stored) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (attributes[i].kind == AttributeKind::light)
        values[i] = stored_of_mean(attributes[i], mean_of_stored(attributes[i], values[i]));
    }
    return take_normal(shape, vertex);
  }
  double square = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (attributes[i].kind == AttributeKind::normal) square += values[i] * values[i];
    values[i] = stored_of_mean(attributes[i], values[i]);
  }
  const double length = std::sqrt(square);
  const bool unit = std::abs(length - 1) <= unit_tolerance;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (attributes[i].kind != AttributeKind::normal) continue;
    if (!unit)
      values[i] = length > 0 ? values[i] / length : double{vertex.normal.at(axis_of_normal(attributes[i]))};
  }
  take_normal(shape, vertex);
}

}  // namespace winnow
