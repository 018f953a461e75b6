#include "python/reports.hpp"

#include "python/errors.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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
py::object value_of(Refine cost) {
  constexpr std::array names{"none", "quadric", "volume", "importance"};
  return py::str(names.at(static_cast<std::size_t>(cost)));
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
  void operator()(const std::string& path, const Resumed& resumed) {
    (*this)(path + ".rounds", resumed.rounds);
  }
  void operator()(const std::string& path, const Distances& distances, double diagonal) {
    for (const auto& [name, value] :
         {std::pair{"mean", distances.mean}, std::pair{"rms", distances.rms},
          std::pair{"max", distances.max}}) {
      (*this)(path + "." + name, value);
      (*this)(path + "." + name + "_percent", diagonal > 0 ? 100 * value / diagonal : 0);
    }
  }
  void operator()(const std::string& path, const CompareReport::Mesh& mesh) {
    (*this)(path + ".format", mesh.format);
    (*this)(path + ".faces", mesh.faces);
    (*this)(path + ".bad_faces", mesh.bad_faces);
    (*this)(path + ".area", mesh.area);
    (*this)(path + ".volume", mesh.volume);
    (*this)(path + ".samples", mesh.samples);
  }
  // Messages.
  void told(const std::string& path, std::vector<std::string> texts) {
    for (std::string& text : texts) text = spelled(text);
    (*this)(path, texts);
  }

  [[nodiscard]] py::dict dict() const { return root_; }

 private:
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

}  // namespace

py::dict dict_of(const SimplifyReport& report) {
  Fields fields;
  for_each_result(report, fields);
  for_each_run_field(report, fields);
  for (const auto& [path, texts] : {std::pair{"missed_by", &report.missed_by},
                                    std::pair{"attributes.dropped", &report.attributes.dropped},
                                    std::pair{"notes", &report.notes}})
    fields.told(path, *texts);
  fields("clustered.reason", spelled(report.clustered.reason));
  return fields.dict();
}

py::dict dict_of(const ConvertReport& report) {
  Fields fields;
  fields("input.format", report.input.format);
  fields("input.faces", report.input.faces);
  fields("input.vertices", report.input.vertices);
  fields("input.bytes", report.input.bytes);
  fields("input.bad_faces", report.input.bad_faces);
  fields("output.format", report.output.format);
  fields("output.faces", report.output.faces);
  fields("output.vertices", report.output.vertices);
  fields("output.bytes", report.output.bytes);
  fields("output.position_error", report.output.position_error);
  fields("attributes.carried", report.attributes.carried);
  fields.told("attributes.dropped", report.attributes.dropped);
  fields("welded", report.welded);
  fields("doubled_faces", report.doubled_faces);
  fields("spilled_bytes", report.spilled_bytes);
  fields("peak_scratch_bytes", report.peak_scratch_bytes);
  fields("peak_memory_bytes", report.peak_memory_bytes);
  fields("seconds", report.seconds.total);
  fields.told("notes", report.notes);
  return fields.dict();
}

py::dict dict_of(const InfoReport& report) {
  Fields fields;
  fields("format", report.format);
  fields("bytes", report.bytes);
  fields("faces", report.faces);
  fields("vertices", report.vertices);
  fields("bad_faces", report.bad_faces);
  fields("zero_area", report.zero_area);
  fields("box", std::optional<double>());
  if (report.has_box) {
    Fields box;
    box("min", report.box_min);
    box("max", report.box_max);
    fields.dict()["box"] = box.dict();
  }
  fields("area", report.area);
  fields("mean_edge", report.mean_edge);
  fields("attributes", report.attributes);
  fields("edges.total", report.edges.total);
  fields("edges.boundary", report.edges.boundary);
  fields("edges.non_manifold", report.edges.non_manifold);
  fields("watertight", report.watertight);
  fields("parts", report.parts);
  fields("volume", report.volume);
  fields("spilled_bytes", report.spilled_bytes);
  fields("peak_scratch_bytes", report.peak_scratch_bytes);
  fields("peak_memory_bytes", report.peak_memory_bytes);
  fields("seconds", report.seconds);
  fields.told("notes", report.notes);
  return fields.dict();
}

py::dict dict_of(const CompareReport& report) {
  Fields fields;
  fields("original", report.original);
  fields("simplified", report.simplified);
  fields("diagonal", report.diagonal);
  fields("distance.forward", report.forward, report.diagonal);
  fields("distance.backward", report.backward, report.diagonal);
  fields("distance.symmetric", report.symmetric, report.diagonal);
  fields("distance.worst", report.worst);
  fields("fail_above", std::optional<double>());
  if (report.limit) {
    Fields limit;
    limit("length", report.limit->length);
    limit("exceeded", report.limit->exceeded);
    fields.dict()["fail_above"] = limit.dict();
  }
  fields("normal_deviation.mean", report.normal_deviation.mean);
  fields("normal_deviation.p95", report.normal_deviation.p95);
  fields("topology.boundary_edges", report.topology.boundary_edges);
  fields("topology.non_manifold_edges", report.topology.non_manifold_edges);
  fields("topology.flipped", report.topology.flipped);
  fields("topology.degenerate", report.topology.degenerate);
  fields("topology.duplicate", report.topology.duplicate);
  fields("topology.components", report.topology.components);
  fields("smallest_angles.min", report.smallest_angles.min);
  fields("smallest_angles.mean", report.smallest_angles.mean);
  fields("smallest_angles.below_10", report.smallest_angles.below_10);
  fields("area_change", report.area_change);
  fields("volume_change", report.volume_change);
  fields("peak_memory_bytes", report.peak_memory_bytes);
  fields("seconds", report.seconds);
  fields.told("notes", report.notes);
  return fields.dict();
}

}  // namespace winnow::python
