#include "run/attributes.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

AttributeRequest wish_for(const SimplifyOptions& options, const MeshEncoder& encoder) {
  AttributeRequest wish;
  wish.names = options.attributes;
  wish.no_data = options.nodata;
  wish.refusal = [&encoder, normals = options.normals](
                     const Attribute& attribute, std::span<const Attribute> wanted) -> std::string {
    if (normals && names_normal(attribute))
      return "normals of the input, as `normals` computes those of the result:";
    return encoder.attribute_refusal(attribute, wanted);
  };
  return wish;
}

bool writes_normals(std::span<const Attribute> attributes, const MeshEncoder& encoder,
                    bool computed) {
  if (carries_normals(attributes)) return encoder.normals_apart();
  return computed && std::none_of(attributes.begin(), attributes.end(), names_normal);
}

std::vector<std::string> descriptions(const AttributeSelection& choice) {
  std::vector<std::string> lines;
  for (const Attribute& attribute : choice.carried) lines.push_back(described(attribute));
  return lines;
}

void note_dropped(Job& job, const AttributeSelection& choice) {
  std::string line;
  for (const std::string& what : choice.dropped)
    line += (line.empty() ? "not carried: " : "; ") + what;
  if (!line.empty()) job.note(line);
}

void settle_colors(Job& job, std::vector<Attribute>& attributes,
                   const std::vector<MeshReader::AttributeRange>& ranges) {
  // Red, green and blue have one measure; alpha has its own.
  std::array<double, 2> largest{};
  const auto group_of = [&](const Attribute& attribute) -> std::optional<std::size_t> {
    if (is_integer(attribute.type)) return {};
    if (attribute.kind == AttributeKind::color) return 0;
    return component_named(attribute.name) == 3 ? std::optional<std::size_t>(1) : std::nullopt;
  };
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const std::optional<std::size_t> group = group_of(attributes[i]);
    if (group) largest[*group] = std::max(largest[*group], ranges[i].largest);
  }
  std::array<double, 2> full{};
  for (std::size_t group = 0; group < full.size(); ++group) {
    const std::string seen = shortest(std::round(1000 * largest[group]) / 1000);
    const char* const what = group == 0 ? "colours" : "alpha";
    full[group] = largest[group] <= 2 ? 1 : largest[group] <= 255 ? 255 : 65535;
    if (full[group] > 1)
      job.note(std::string(what) + " are reals up to " + seen + ": " + shortest(full[group]) +
               " was taken for 1");
    if (largest[group] > full[group])
      job.note(std::string(what) + " above " + shortest(full[group]) + " (up to " + seen +
               ") were clipped");
  }
  for (Attribute& attribute : attributes) {
    if (const std::optional<std::size_t> group = group_of(attribute)) attribute.full = full[*group];
  }
}

TakenAttributes take_attributes(Job& job, MeshReader& reader) {
  const AttributeSelection& choice = reader.facts().choice;
  TakenAttributes taken{{choice.carried, {}}, {descriptions(choice), choice.dropped, 0}};
  const std::vector<MeshReader::AttributeRange> ranges = reader.attribute_ranges();
  settle_colors(job, taken.carried.attributes, ranges);
  for (const MeshReader::AttributeRange& range : ranges) {
    taken.carried.largest.push_back(range.largest);
    taken.report.ignored += range.without;
  }
  note_dropped(job, choice);
  if (taken.report.ignored > 0) {
    job.note(grouped(taken.report.ignored) +
             " numbers of carried attributes are not finite, or the largest of their type; the "
             "means leave them out");
  }
  return taken;
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
      values[i] =
          length > 0 ? values[i] / length : double{vertex.normal.at(axis_of_normal(attributes[i]))};
  }
  take_normal(shape, vertex);
}

}  // namespace winnow
