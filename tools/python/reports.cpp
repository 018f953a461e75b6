#include "python/reports.hpp"

#include "python/errors.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <pybind11/stl.h>

namespace winnow::python {

namespace {

namespace py = pybind11;

py::object value_of(std::uint64_t value) {
  return py::int_(value);
}
py::object value_of(double value) {
  return py::float_(value);
}
py::object value_of(bool value) {
  return py::bool_(value);
}
py::object value_of(const std::string& value) {
  return py::str(value);
}
template <typename Value>
requires std::is_enum_v<Value> py::object value_of(Value value) {
  return py::str(facts_of(value).name);
}
template <typename Value>
requires std::is_enum_v<Value> py::object value_of(const std::vector<Value>& values) {
  py::list list;
  for (const Value value : values) list.append(value_of(value));
  return list;
}
py::object value_of(const std::vector<std::string>& values) {
  py::list list;
  for (const std::string& value : values) list.append(value);
  return list;
}
py::object value_of(const std::array<double, 3>& value) {
  return py::make_tuple(value[0], value[1], value[2]);
}

// Puts values at their places: "input.faces" is `faces` of a dict called `input`.
class Fields {
 public:
  template <typename Value>
  void operator()(const std::string& path, const Value& value) {
    set(path, value_of(value));
  }
  template <typename Value>
  void operator()(const std::string& path, const std::optional<Value>& value) {
    if (value) {
      (*this)(path, *value);
    } else {
      set(path, py::none());
    }
  }
  void operator()(const std::string& path, const BadFaces& bad) {
    (*this)(path + ".degenerate", bad.degenerate);
    (*this)(path + ".non_finite", bad.non_finite);
    (*this)(path + ".out_of_range", bad.out_of_range);
  }
  void operator()(const std::string& path, const SurfaceEdges& edges) {
    (*this)(path + ".edges", edges.total);
    (*this)(path + ".boundary", edges.boundary);
    (*this)(path + ".non_manifold", edges.non_manifold);
  }
  void operator()(const std::string& path, const std::vector<ProgressiveInfo::Prefix>& prefixes) {
    py::list list;
    for (const ProgressiveInfo::Prefix& prefix : prefixes) {
      py::dict dict;
      dict["faces"] = prefix.faces;
      dict["bytes"] = prefix.bytes;
      dict["error"] = prefix.error;
      list.append(dict);
    }
    set(path, list);
  }
  void operator()(const std::string& path, const std::vector<LevelReport>& levels) {
    py::list list;
    for (const LevelReport& level : levels) {
      Fields fields;
      for_each_level_field(level, fields);
      list.append(fields.dict());
    }
    set(path, list);
  }
  void operator()(const std::string& path, const Resumed& resumed) {
    (*this)(path + ".rounds", resumed.rounds);
  }
  void operator()(const std::string& path, const InfoReport::Box& box) {
    (*this)(path + ".min", box.min);
    (*this)(path + ".max", box.max);
  }
  void operator()(const std::string& path, const CompareReport::Limit& limit) {
    (*this)(path + ".length", limit.length);
    (*this)(path + ".exceeded", limit.exceeded);
  }
  void operator()(const std::string& path, const std::string& text) {
    set(path, value_of(is_message(path) ? spelled(text) : text));
  }
  void operator()(const std::string& path, std::vector<std::string> texts) {
    if (is_message(path)) {
      for (std::string& text : texts) text = spelled(text);
    }
    set(path, value_of(texts));
  }

  [[nodiscard]] py::dict dict() const { return root_; }

 private:
  static bool is_message(const std::string& path) {
    return path.ends_with("notes") || path.ends_with("reason") || path.ends_with("dropped");
  }
  void set(const std::string& path, const py::object& value) {
    py::dict dict = root_;
    std::size_t begin = 0;
    for (std::size_t dot = 0; (dot = path.find('.', begin)) != std::string::npos; begin = dot + 1) {
      const py::str name(path.substr(begin, dot - begin));
      if (!dict.contains(name)) dict[name] = py::dict();
      dict = dict[name];
    }
    dict[py::str(path.substr(begin))] = value;
  }

  py::dict root_;
};

template <typename Report>
py::dict dict_by_table(const Report& report) {
  Fields fields;
  for_each_field(report, fields);
  return fields.dict();
}

}  // namespace

py::dict dict_of(const SimplifyReport& report) {
  return dict_by_table(report);
}
py::dict dict_of(const ConvertReport& report) {
  return dict_by_table(report);
}
py::dict dict_of(const InfoReport& report) {
  return dict_by_table(report);
}
py::dict dict_of(const CompareReport& report) {
  return dict_by_table(report);
}
py::dict dict_of(const ProgressiveReport& report) {
  return dict_by_table(report);
}
py::dict dict_of(const ProgressiveInfo& info) {
  return dict_by_table(info);
}
py::dict dict_of(const ExtractReport& report) {
  return dict_by_table(report);
}

}  // namespace winnow::python
