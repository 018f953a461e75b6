#include "read/view_arrays.hpp"

#include <winnow/error.hpp>

#include "base/number_type.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <string>
#include <utility>

namespace winnow {

namespace {

template <std::size_t Width>
void check_rows(const Rows<Width>& rows, const std::string& name) {
  const std::size_t bytes = Width * size_of(rows.type());
  if (rows.left_over() != 0) {
    throw Error(ErrorKind::bad_input,
                name + " holds " + grouped(Width * rows.count() + rows.left_over()) +
                    " numbers, which is no multiple of " + std::to_string(Width));
  }
  if (rows.count() > 0 && rows.data() == nullptr)
    throw Error(ErrorKind::usage, name + " has rows, but no memory that they are in");
  if (rows.count() > 1 && rows.stride() < bytes) {
    throw Error(ErrorKind::usage, name + ": rows of " + std::to_string(bytes) +
                                      " bytes cannot stand " + std::to_string(rows.stride()) +
                                      " bytes apart");
  }
}

// What a name may be in a PLY, and so in every file that the mesh is written to.
bool is_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(),
                                      [](char letter) { return letter > ' ' && letter != '\x7f'; });
}

void check_attribute(const MeshView::Attribute& attribute, std::uint64_t vertices) {
  if (!is_name(attribute.name)) {
    throw Error(ErrorKind::usage, "`attributes`: '" + attribute.name +
                                      "' is no name; it takes letters without spaces");
  }
  const std::string name = "`attributes`: '" + attribute.name + "'";
  if (attribute.name == "x" || attribute.name == "y" || attribute.name == "z")
    throw Error(ErrorKind::usage, name + " is the name of a coordinate; choose another");
  check_rows(attribute.values, name);
  if (is_wide_integer(attribute.values.type())) {
    throw Error(ErrorKind::usage,
                name + " has whole numbers of 64 bits; only up to 32 are carried, or doubles");
  }
  if (attribute.values.count() != vertices) {
    throw Error(ErrorKind::bad_input, name + " has " + grouped(attribute.values.count()) +
                                          " values, but there are " + grouped(vertices) +
                                          " vertices");
  }
}

constexpr std::uint32_t of_no_vertex = UINT32_MAX;

template <typename Index>
void load_indices(const std::byte* row, std::size_t stride, std::size_t count, std::uint32_t* out) {
  for (std::size_t i = 0; i < count; ++i, row += stride) {
    std::array<Index, 3> face;
    std::memcpy(face.data(), row, sizeof face);
    for (const Index index : face)
      *out++ = std::cmp_less(index, 0) || std::cmp_greater(index, of_no_vertex)
                   ? of_no_vertex
                   : static_cast<std::uint32_t>(index);
  }
}

}  // namespace

void check_batch(const MeshView& mesh) {
  check_rows(mesh.positions, "`positions`");
  check_rows(mesh.faces, "`faces`");
  // In a default view nothing has the right type.
  if (mesh.positions.count() > 0 && mesh.positions.type() < NumberType::float32)
    throw Error(ErrorKind::usage, "`positions` takes floats or doubles, not whole numbers");
  if (mesh.faces.count() > 0 &&
      (mesh.faces.type() < NumberType::int32 || mesh.faces.type() > NumberType::uint64))
    throw Error(ErrorKind::usage, "`faces` takes whole numbers of 32 or 64 bits");
  if (mesh.positions.count() > UINT32_MAX) {
    throw Error(ErrorKind::bad_input, "`positions` holds " + grouped(mesh.positions.count()) +
                                          " vertices; at most " + grouped(UINT32_MAX) +
                                          " are counted");
  }
  std::set<std::string> names;
  for (const MeshView::Attribute& attribute : mesh.attributes) {
    check_attribute(attribute, mesh.positions.count());
    if (!names.insert(attribute.name).second)
      throw Error(ErrorKind::usage, "`attributes` has '" + attribute.name + "' twice");
  }
}

void check_view(const MeshView& mesh) {
  check_rows(mesh.positions, "`positions`");
  check_rows(mesh.faces, "`faces`");
  if (mesh.positions.count() == 0)
    throw Error(ErrorKind::bad_input, "`positions` is empty; there is nothing to simplify");
  if (mesh.faces.count() == 0)
    throw Error(ErrorKind::bad_input, "`faces` is empty; there is nothing to simplify");
  check_batch(mesh);
}

std::vector<Attribute> attributes_of(const MeshView& mesh) {
  std::vector<Attribute> attributes;
  for (const MeshView::Attribute& attribute : mesh.attributes)
    attributes.push_back({attribute.name, attribute.values.type()});
  return attributes;
}

void load_faces(const Rows<3>& faces, std::uint64_t first, std::size_t count,
                std::uint32_t* corners) {
  const std::size_t stride = faces.stride();
  const std::byte* rows = static_cast<const std::byte*>(faces.data()) + first * stride;
  switch (faces.type()) {
    case NumberType::int32:
      return load_indices<std::int32_t>(rows, stride, count, corners);
    case NumberType::int64:
      return load_indices<std::int64_t>(rows, stride, count, corners);
    case NumberType::uint64:
      return load_indices<std::uint64_t>(rows, stride, count, corners);
    default:
      return load_indices<std::uint32_t>(rows, stride, count, corners);
  }
}

}  // namespace winnow
