// Every report as JSON, by its table for_each_field().
#pragma once

#include <winnow/compare.hpp>
#include <winnow/compare_sequence.hpp>
#include <winnow/info.hpp>
#include <winnow/progressive.hpp>
#include <winnow/simplify.hpp>

#include "report_text.hpp"
#include "table_options.hpp"

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace winnow::cli {

inline Json json_of(const BadFaces& bad) {
  return {{"degenerate", bad.degenerate},
          {"non_finite", bad.non_finite},
          {"out_of_range", bad.out_of_range}};
}

inline Json json_of(const SurfaceEdges& edges) {
  return {
      {"edges", edges.total}, {"boundary", edges.boundary}, {"non_manifold", edges.non_manifold}};
}

inline Json json_of(const Resumed& resumed) {
  return {{"clustered", resumed.clustered},
          {"rounds", resumed.rounds},
          {"tiles", resumed.tiles},
          {"written", resumed.written}};
}

inline Json json_of(const InfoReport::Box& box) {
  return {{"min", box.min}, {"max", box.max}};
}

inline Json json_of(const CompareReport::Limit& limit) {
  return {{"length", limit.length}, {"exceeded", limit.exceeded}};
}

inline Json json_of(const SequenceComparison::Flicker& flicker) {
  return {{"simplified", flicker.simplified}, {"original", flicker.original}};
}

inline Json json_of(const std::vector<SimplifyPlan::Part>& parts) {
  Json json = Json::object();
  for (const SimplifyPlan::Part& part : parts) json[spoken(part.name)] = part.bytes;
  return json;
}

inline Json json_of(const std::vector<ProgressiveInfo::Prefix>& prefixes) {
  Json json = Json::array();
  for (const ProgressiveInfo::Prefix& prefix : prefixes) {
    json.push_back({{"faces", prefix.faces}, {"bytes", prefix.bytes}});
    if (prefix.error) json.back()["error"] = *prefix.error;
  }
  return json;
}

template <typename Value>
requires std::is_enum_v<Value> Json json_of(const Value& value) {
  return facts_of(value).name;
}

template <typename Value>
Json json_of(const Value& value) {
  return value;
}

template <typename Value>
requires std::is_enum_v<Value> Json json_of(const std::vector<Value>& values) {
  Json json = Json::array();
  for (const Value value : values) json.push_back(json_of(value));
  return json;
}

template <typename Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json(nullptr);
}

// Puts every field of a report at its place; a text that is empty is null.
class JsonFields {
 public:
  template <typename Value>
  void operator()(const std::string& path, const Value& value) {
    at(path) = json_of(value);
  }
  void operator()(const std::string& path, const std::string& text) {
    at(path) = text.empty() ? Json(nullptr) : Json(told(path, text));
  }
  void operator()(const std::string& path, const std::vector<std::string>& texts) {
    at(path) = Json::array();
    for (const std::string& text : texts) at(path).push_back(told(path, text));
  }

  void operator()(const std::string& path, const std::vector<LevelReport>& levels) {
    at(path) = Json::array();
    for (const LevelReport& level : levels) {
      JsonFields fields;
      for_each_level_field(level, fields);
      at(path).push_back(fields.json());
    }
  }

  [[nodiscard]] const Json& json() const { return json_; }

 private:
  // What comes from a file or the command line is no message.
  static std::string told(const std::string& path, const std::string& text) {
    const bool message =
        path.ends_with("notes") || path.ends_with("reason") || path.ends_with("dropped");
    return message ? spoken(text) : text;
  }
  Json& at(const std::string& path) {
    std::string pointer = "/" + path;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    return json_[Json::json_pointer(pointer)];
  }

  Json json_;
};

template <typename Report>
Json json_of_report(const Report& report) {
  JsonFields fields;
  for_each_field(report, fields);
  return fields.json();
}

// As JSON, or as show() writes it for people, or not at all.
template <typename Report>
void tell(const Report& report, const CommonOptions& options, std::ostream& out,
          void (*show)(const Report&, std::ostream&)) {
  if (options.json) {
    print(json_of_report(report), options, out);
  } else if (!options.quiet) {
    show(report, out);
  }
}

}  // namespace winnow::cli
