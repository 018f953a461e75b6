#include "read/ply/header_facts.hpp"

#include <winnow/error.hpp>

#include "read/ply/values.hpp"

#include <array>

namespace winnow {

namespace {

// The property that holds a face's indices; nothing where the element has none.
const PlyProperty* index_list(const PlyElement& element) {
  for (const char* name : {"vertex_indices", "vertex_index"}) {
    const PlyProperty* property = element.find(name);
    if (property != nullptr && property->list) return property;
  }
  return nullptr;
}

}  // namespace

PlyFaces find_faces(const PlyHeader& header, const std::string& name) {
  PlyFaces found;
  for (const char* element : {"face", "tristrips"}) {
    const PlyElement* candidate = header.find(element);
    if (candidate == nullptr || candidate->count == 0) continue;
    found = {candidate, index_list(*candidate), std::string(element) == "tristrips"};
    if (found.list == nullptr) {
      throw Error(ErrorKind::bad_input, "'" + name + "': the PLY element '" + std::string(element) +
                                            "' has no list 'vertex_indices' or 'vertex_index'");
    }
    break;
  }
  return found;
}

std::size_t triangle_stride(const PlyHeader& header, const PlyFaces& faces) {
  if (header.form == PlyForm::ascii || faces.strips || size_of(faces.list->count_type) != 1 ||
      !(faces.list->type == PlyType::int32 || faces.list->type == PlyType::uint32)) {
    return 0;
  }
  std::size_t size = 13;
  for (const PlyProperty& property : faces.element->properties) {
    if (&property == faces.list) continue;
    if (property.list) return 0;
    size += size_of(property.type);
  }
  return size;
}

bool surely_triangles(const PlyHeader& header, const PlyFaces& faces,
                      std::optional<std::uint64_t> size) {
  if (faces.element == nullptr) return true;
  const std::size_t stride = triangle_stride(header, faces);
  if (stride == 0 || !size) return false;
  std::uint64_t bytes = header.bytes;
  for (const PlyElement& element : header.elements) {
    if (&element != faces.element && !element.fixed_size()) return false;
    bytes += element.count * (&element == faces.element ? stride : element.smallest_size());
  }
  return bytes == *size;
}

InputFacts ply_facts(const PlyHeader& header) {
  InputFacts facts;
  constexpr std::array forms{"ASCII", "binary little-endian", "binary big-endian"};
  facts.format = std::string("PLY ") + forms.at(static_cast<std::size_t>(header.form));
  const PlyElement* vertex = header.find("vertex");
  const PlyElement* face = header.find("face");
  facts.vertices = vertex == nullptr ? 0 : vertex->count;
  facts.faces = face == nullptr ? 0 : face->count;
  if (*facts.faces == 0 && header.find("tristrips") != nullptr) facts.faces.reset();
  for (const PlyElement& element : header.elements) {
    std::string line = element.name + ":";
    const PlyProperty* indices = index_list(element);
    for (const PlyProperty& property : element.properties) {
      const bool geometry =
          (element.name == "vertex" && is_coordinate(property)) || &property == indices;
      if (!geometry)
        line += " " + property.name + (property.list ? " (list of " : " (") +
                name_of(property.type) + ")";
    }
    if (line != element.name + ":") facts.attributes.push_back(line);
    if (&element != vertex) continue;
    for (const char* axis : {"x", "y", "z"}) {
      const PlyProperty* property = element.find(axis);
      facts.double_positions |= property != nullptr && (property->type == PlyType::float64 ||
                                                        property->type == PlyType::int32 ||
                                                        property->type == PlyType::uint32);
    }
    facts.normals = element.find("nx") != nullptr && element.find("ny") != nullptr &&
                    element.find("nz") != nullptr;
  }
  return facts;
}

AvailableAttributes available_attributes(const PlyHeader& header) {
  AvailableAttributes offer;
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    const bool faces = element.name == "face" || element.name == "tristrips";
    if (element.name != "vertex" && !faces) offer.of_nothing.push_back(element.name);
    const PlyProperty* indices = index_list(element);
    for (const PlyProperty& property : element.properties) {
      if (faces && &property != indices) offer.of_faces.push_back(property.name);
      if (element.name != "vertex" || is_coordinate(property)) continue;
      if (property.list) {
        offer.lists.push_back(property.name);
      } else {
        offer.scalars.push_back({property.name, property.type});
      }
    }
  }
  return offer;
}

}  // namespace winnow
