#include "python/arrays.hpp"

#include <cstring>
#include <stdexcept>
#include <variant>

namespace winnow::python {

namespace {

namespace py = pybind11;

template <std::size_t Width, typename T>
bool add_rows(const py::array& array, Rows<Width>& rows) {
  if (!array.dtype().is(py::dtype::of<T>()) && !array.dtype().equal(py::dtype::of<T>()))
    return false;
  rows =
      Rows<Width>(static_cast<const T*>(array.data()), static_cast<std::uint64_t>(array.shape(0)),
                  static_cast<std::size_t>(array.strides(0)));
  return true;
}

template <std::size_t Width>
Rows<Width> rows_of_width(const py::array& array) {
  Rows<Width> rows;
  const bool known =
      add_rows<Width, float>(array, rows) || add_rows<Width, double>(array, rows) ||
      add_rows<Width, std::int32_t>(array, rows) || add_rows<Width, std::int64_t>(array, rows) ||
      add_rows<Width, std::uint32_t>(array, rows) || add_rows<Width, std::uint64_t>(array, rows) ||
      add_rows<Width, std::int8_t>(array, rows) || add_rows<Width, std::uint8_t>(array, rows) ||
      add_rows<Width, std::int16_t>(array, rows) || add_rows<Width, std::uint16_t>(array, rows);
  if (!known) throw py::type_error("an array of numbers that winnow does not know");
  return rows;
}

// A copy in memory of numpy's own; `numbers` is freed.
template <typename T>
py::array owned(std::vector<T> numbers, std::vector<py::ssize_t> shape) {
  py::array array(py::dtype::of<T>(), std::move(shape));
  if (!numbers.empty())
    std::memcpy(array.mutable_data(), numbers.data(), numbers.size() * sizeof(T));
  return array;
}

template <typename T>
py::array owned_triples(std::vector<T> numbers) {
  const auto count = static_cast<py::ssize_t>(numbers.size() / 3);
  return owned(std::move(numbers), {count, 3});
}

}  // namespace

Rows<3> rows_of(const py::array& array) {
  return rows_of_width<3>(array);
}

MeshView view_of(const py::array& points, const py::array& faces, const NamedArrays& attributes) {
  MeshView view;
  view.positions = rows_of(points);
  view.faces = rows_of(faces);
  for (const auto& [name, values] : attributes)
    view.attributes.push_back({name, rows_of_width<1>(values)});
  return view;
}

py::tuple arrays_of(Mesh mesh) {
  py::array points =
      std::visit([](auto& numbers) { return owned_triples(std::move(numbers)); }, mesh.positions);
  py::array faces = owned_triples(std::move(mesh.faces));
  py::dict attributes;
  for (Mesh::Attribute& attribute : mesh.attributes) {
    attributes[py::str(attribute.name)] = std::visit(
        [](auto& values) {
          const auto count = static_cast<py::ssize_t>(values.size());
          return owned(std::move(values), {count});
        },
        attribute.values);
  }
  return py::make_tuple(points, faces, attributes);
}

py::array array_of(VertexMap map) {
  const auto count = static_cast<py::ssize_t>(map.size());
  return owned(std::move(map), {count});
}

}  // namespace winnow::python
