// winnow._winnow: the calls of the library, with options as texts and reports as dicts. The package
// around it (winnow/) gives them their names, keywords and checks.
#include <winnow/parts.hpp>
#include <winnow/progressive.hpp>
#include <winnow/simplification.hpp>
#include <winnow/version.hpp>

#include "python/arrays.hpp"
#include "python/errors.hpp"
#include "python/option_texts.hpp"
#include "python/reports.hpp"
#include "python/running.hpp"
#include "python/sequences.hpp"

#include <memory>
#include <optional>
#include <vector>

#include <pybind11/stl.h>

namespace winnow::python {

namespace {

namespace py = pybind11;

SimplifyOptions simplify_options_of(const Texts& options) {
  SimplifyOptions read_options;
  read(read_options, simplify_options(), options);
  return read_options;
}

py::tuple simplify_arrays(const py::array& points, const py::array& faces,
                          const NamedArrays& attributes, bool return_map, const Texts& options,
                          const Texts& surroundings, const py::object& progress) {
  Context context;
  read(context, context_options(), surroundings);
  const SimplifyOptions wanted = simplify_options_of(options);
  const MeshView view = view_of(points, faces, attributes);
  SimplifyReport report;
  Mesh mesh;
  VertexMap map;
  run(context, progress,
      [&] { mesh = simplify(context, view, wanted, &report, return_map ? &map : nullptr); });
  return py::make_tuple(arrays_of(std::move(mesh)), array_of(std::move(map)), dict_of(report));
}

// What a call of the library tells, made with these surroundings and this progress.
template <typename Call>
py::dict told_by(const Call& call, const Texts& surroundings, const py::object& progress) {
  Context context;
  read(context, context_options(), surroundings);
  decltype(call(context)) report;
  run(context, progress, [&] { report = call(context); });
  return dict_of(report);
}

py::dict simplify_files(const std::vector<std::string>& inputs, const std::string& output,
                        const Texts& options, const Texts& surroundings,
                        const py::object& progress) {
  const SimplifyOptions wanted = simplify_options_of(options);
  const auto call = [&](Context& context) { return simplify(context, inputs, output, wanted); };
  return told_by(call, surroundings, progress);
}

py::dict convert_file(const std::string& input, const std::string& output, const Texts& options,
                      const Texts& surroundings, const py::object& progress) {
  ConvertOptions wanted;
  read(wanted, convert_options(), options);
  const auto call = [&](Context& context) { return convert(context, input, output, wanted); };
  return told_by(call, surroundings, progress);
}

py::dict compare_files(const std::string& original, const std::string& simplified,
                       const Texts& options, const Texts& surroundings,
                       const py::object& progress) {
  CompareOptions wanted;
  read(wanted, compare_options(), options);
  const auto call = [&](Context& context) {
    return compare(context, original, simplified, wanted);
  };
  return told_by(call, surroundings, progress);
}

py::dict info_of_file(const std::string& input, const Texts& options, const Texts& surroundings,
                      const py::object& progress) {
  ConvertOptions wanted;
  read(wanted, convert_options(), options);
  const auto call = [&](Context& context) { return info(context, input, wanted.from); };
  return told_by(call, surroundings, progress);
}

py::dict progressive_file(const std::vector<std::string>& inputs, const std::string& output,
                          const Texts& options, const Texts& surroundings,
                          const py::object& progress) {
  ProgressiveOptions wanted;
  read(wanted, progressive_options(), options);
  const auto call = [&](Context& context) { return progressive(context, inputs, output, wanted); };
  return told_by(call, surroundings, progress);
}

py::dict info_of_levels(const std::string& input, const Texts& surroundings) {
  const auto call = [&](Context& context) { return progressive_info(context, input); };
  return told_by(call, surroundings, py::none());
}

py::tuple extract_arrays(const std::string& input, const Texts& options, const Texts& surroundings,
                         const py::object& progress) {
  Context context;
  read(context, context_options(), surroundings);
  ExtractOptions wanted;
  read(wanted, extract_options(), options);
  ExtractReport report;
  Mesh mesh;
  run(context, progress, [&] { mesh = extract(context, input, wanted, &report); });
  return py::make_tuple(arrays_of(std::move(mesh)), dict_of(report));
}

// What KeptFrames gives, and whether frames have faces of their own.
py::tuple simplify_frames(const std::vector<py::array>& points, const py::array& faces,
                          const Texts& options, const Texts& surroundings,
                          const py::object& progress) {
  Context context;
  read(context, context_options(), surroundings);
  SequenceOptions wanted;
  read(wanted, sequence_options(), options);
  ArrayFrames frames(points, faces);
  KeptFrames kept;
  run(context, progress, [&] { simplify_sequence(context, frames, kept, wanted); });
  return py::make_tuple(std::move(kept).arrays(), wanted.per_frame > 0);
}

// ProgressiveMesh.
class ShownLevel {
 public:
  ShownLevel(const std::string& input, const Texts& surroundings) {
    read(context_, context_options(), surroundings);
    run(context_, py::none(), [&] { mesh_.emplace(context_, input); });
  }

  void go_to(std::uint64_t faces) {
    run(context_, py::none(), [&] { mesh_->go_to(faces); });
  }
  bool step_forward() { return mesh_->step_forward(); }
  bool step_back() { return mesh_->step_back(); }
  [[nodiscard]] std::uint64_t face_count() const { return mesh_->face_count(); }
  [[nodiscard]] py::tuple arrays() const { return arrays_of(mesh_->mesh()); }

 private:
  Context context_;
  std::optional<ProgressiveMesh> mesh_;
};

// Simplification, whose batches are C-ordered arrays.
class Stream {
 public:
  Stream(const std::string& output, const Texts& options, const Texts& surroundings) {
    read(context_, context_options(), surroundings);
    simplification_ =
        std::make_unique<Simplification>(context_, output, simplify_options_of(options));
  }

  template <typename Coordinate>
  void add_points(const py::array_t<Coordinate, py::array::c_style>& points) {
    const std::span numbers(points.data(), static_cast<std::size_t>(points.size()));
    const py::gil_scoped_release unlocked;
    simplification_->add_vertices(numbers);
  }

  // Each number is that of one of `count` points, the first of which is point `first` of all.
  void add_faces(const py::array_t<std::int64_t, py::array::c_style>& faces, std::int64_t first,
                 std::int64_t count) {
    const std::span numbers(faces.data(), static_cast<std::size_t>(faces.size()));
    const py::gil_scoped_release unlocked;
    constexpr std::int64_t of_no_vertex = UINT32_MAX;
    std::vector<std::uint32_t> corners;
    corners.reserve(numbers.size());
    for (const std::int64_t number : numbers) {
      const bool there = number >= 0 && number < count && number < of_no_vertex - first;
      corners.push_back(static_cast<std::uint32_t>(there ? first + number : of_no_vertex));
    }
    simplification_->add_faces(corners);
  }

  py::dict finish(const py::object& progress) {
    SimplifyReport report;
    run(context_, progress, [&] { report = simplification_->finish(); });
    close();
    return dict_of(report);
  }

  void close() { simplification_.reset(); }

 private:
  Context context_;
  std::unique_ptr<Simplification> simplification_;
};

py::dict tables() {
  py::dict all;
  all["simplify"] = rows_of_table(simplify_options());
  all["convert"] = rows_of_table(convert_options());
  all["compare"] = rows_of_table(compare_options());
  all["progressive"] = rows_of_table(progressive_options());
  all["extract"] = rows_of_table(extract_options());
  all["sequence"] = rows_of_table(sequence_options());
  all["context"] = rows_of_table(context_options());
  return all;
}

}  // namespace

PYBIND11_MODULE(_winnow, module) {
  add_errors(module);
  module.attr("__version__") = WINNOW_VERSION;
  module.def("tables", tables);
  module.def("built_parts", [] {
    py::list parts;
    if (has_part(Part::gltf)) parts.append("gltf");
    if (has_part(Part::compare)) parts.append("compare");
    return parts;
  });
  module.def("simplify_arrays", simplify_arrays);
  module.def("simplify_files", simplify_files);
  module.def("convert_file", convert_file);
  module.def("compare_files", compare_files);
  module.def("info_of_file", info_of_file);
  module.def("progressive_file", progressive_file);
  module.def("info_of_levels", info_of_levels);
  module.def("extract_arrays", extract_arrays);
  module.def("simplify_frames", simplify_frames);
  py::class_<ShownLevel>(module, "ShownLevel")
      .def(py::init<const std::string&, const Texts&>())
      .def("go_to", &ShownLevel::go_to)
      .def("step_forward", &ShownLevel::step_forward)
      .def("step_back", &ShownLevel::step_back)
      .def("face_count", &ShownLevel::face_count)
      .def("arrays", &ShownLevel::arrays);
  py::class_<Stream>(module, "Stream")
      .def(py::init<const std::string&, const Texts&, const Texts&>())
      .def("add_points", &Stream::add_points<float>, py::arg().noconvert())
      .def("add_points", &Stream::add_points<double>, py::arg().noconvert())
      .def("add_faces", &Stream::add_faces)
      .def("finish", &Stream::finish)
      .def("close", &Stream::close);
}

}  // namespace winnow::python
