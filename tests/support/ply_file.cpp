#include "support/ply_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <functional>
#include <stdexcept>

namespace winnow::test {

namespace {

// Calls `use` with `value` as the C++ type behind `type`.
template <typename Use>
void with_type(PlyType type, double value, Use use) {
  switch (type) {
    case PlyType::int8:
      return use(static_cast<std::int8_t>(value));
    case PlyType::uint8:
      return use(static_cast<std::uint8_t>(value));
    case PlyType::int16:
      return use(static_cast<std::int16_t>(value));
    case PlyType::uint16:
      return use(static_cast<std::uint16_t>(value));
    case PlyType::int32:
      return use(static_cast<std::int32_t>(value));
    case PlyType::uint32:
      return use(static_cast<std::uint32_t>(value));
    case PlyType::float32:
      return use(static_cast<float>(value));
    case PlyType::float64:
      return use(value);
    case PlyType::int64:
    case PlyType::uint64:
      break;
  }
  throw std::logic_error("a PLY has no numbers of this type");
}

struct Property {
  std::string name;
  PlyType type{};
  bool list = false;
  PlyType count{};
  std::function<std::vector<double>(std::size_t record)> values;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

class Writer {
 public:
  explicit Writer(const PlyStyle& style) : style_(style) {}

  std::string write(const std::vector<Element>& elements) {
    line("ply");
    remark();
    constexpr std::array forms{"ascii", "binary_little_endian", "binary_big_endian"};
    line(std::string("format ") + forms.at(static_cast<std::size_t>(style_.form)) + " 1.0");
    for (const Element& element : elements) {
      remark();
      line("element " + element.name + " " + std::to_string(element.count));
      for (const Property& property : element.properties) {
        remark();
        const std::string type = type_name(property.type, style_.new_names) + " " + property.name;
        line(property.list
                 ? "property list " + type_name(property.count, style_.new_names) + " " + type
                 : "property " + type);
      }
    }
    line("end_header");
    for (const Element& element : elements) {
      for (std::size_t record = 0; record < element.count; ++record) put_record(element, record);
    }
    return std::move(text_);
  }

 private:
  void line(const std::string& words) { text_ += words + style_.line_end; }

  void remark() {
    if (style_.ornaments == nullptr || !style_.ornaments->chance(0.3)) return;
    line(style_.ornaments->one_of<std::string>({"comment", "comment element face 7",
                                                "obj_info end_header", "obj_info num_cols 512",
                                                "comment property float x", ""}));
  }

  void put_record(const Element& element, std::size_t record) {
    for (const Property& property : element.properties) {
      const std::vector<double> values = property.values(record);
      if (property.list) put(property.count, static_cast<double>(values.size()));
      for (const double value : values) put(property.type, value);
    }
    if (style_.form == PlyForm::ascii && !element.properties.empty())
      text_.replace(text_.size() - 1, 1, style_.line_end);
  }

  void put(PlyType type, double value) {
    with_type(type, value, [this](auto number) {
      std::array<char, 64> buffer{};
      if (style_.form == PlyForm::ascii) {
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
        text_.append(buffer.data(), end);
        text_ += ' ';
        return;
      }
      std::memcpy(buffer.data(), &number, sizeof number);
      if (style_.form == PlyForm::big_endian)
        std::reverse(buffer.data(), buffer.data() + sizeof number);
      text_.append(buffer.data(), sizeof number);
    });
  }

  const PlyStyle& style_;
  std::string text_;
};

Property random_property(Random& random, const std::string& name, bool list) {
  Property property;
  property.name = name;
  property.type = ply_types.at(random.below(ply_types.size()));
  property.list = list;
  property.count = ply_types.at(random.below(whole_types));
  const std::uint64_t seed = random.bits();
  property.values = [seed, list](std::size_t record) {
    Random values(seed + record);
    std::vector<double> out(list ? values.below(5) : 1);
    for (double& value : out) value = static_cast<double>(values.below(120));
    return out;
  };
  return property;
}

void ornament(Random& random, Element& element) {
  for (const char* name : {"nx", "red", "quality", "xx", "flags"}) {
    if (random.chance(0.25)) element.properties.push_back(random_property(random, name, false));
  }
  for (const char* name : {"neighbours", "texcoord"}) {
    if (random.chance(0.2)) element.properties.push_back(random_property(random, name, true));
  }
  random.shuffle(element.properties);
}

Element random_element(Random& random, const std::string& name) {
  Element element{name, random.below(20), {}};
  ornament(random, element);
  return element;
}

struct Numbers {
  PlyType type;
  const char* old_name;
  const char* new_name;
  double largest;
};

const Numbers& numbers_of(PlyType type) {
  static constexpr std::array<Numbers, 8> all{{{PlyType::int8, "char", "int8", 127},
                                               {PlyType::uint8, "uchar", "uint8", 255},
                                               {PlyType::int16, "short", "int16", 32767},
                                               {PlyType::uint16, "ushort", "uint16", 65535},
                                               {PlyType::int32, "int", "int32", 2147483647},
                                               {PlyType::uint32, "uint", "uint32", 4294967295},
                                               {PlyType::float32, "float", "float32", 16777216},
                                               {PlyType::float64, "double", "float64", 9e15}}};
  return *std::ranges::find(all, type, &Numbers::type);
}

double largest_of(PlyType type) {
  return numbers_of(type).largest;
}

}  // namespace

std::string type_name(PlyType type, bool new_names) {
  return new_names ? numbers_of(type).new_name : numbers_of(type).old_name;
}

std::string ply_file(const Polygons& mesh, const PlyStyle& style) {
  Element vertex{"vertex", mesh.vertices.size(), {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    vertex.properties.push_back(
        {std::string(1, static_cast<char>('x' + axis)),
         style.coordinate[axis],
         false,
         {},
         [&mesh, axis](std::size_t i) { return std::vector<double>{mesh.vertices[i][axis]}; }});
  }
  Element face{style.faces, mesh.faces.size(), {}};
  face.properties.push_back({style.list, style.index, true, style.count, [&mesh](std::size_t i) {
                               return std::vector<double>(mesh.faces[i].begin(),
                                                          mesh.faces[i].end());
                             }});
  std::vector<Element> elements{vertex, face};
  if (style.faces_first) std::swap(elements[0], elements[1]);
  if (style.ornaments != nullptr) {
    Random& random = *style.ornaments;
    for (Element& element : elements) ornament(random, element);
    for (const char* name : {"edge", "camera", "vertexes", "user_data"}) {
      if (!random.chance(0.3)) continue;
      const auto place =
          elements.begin() + static_cast<std::ptrdiff_t>(random.below(elements.size() + 1));
      elements.insert(place, random_element(random, name));
    }
  }
  return Writer(style).write(elements);
}

PlyStyle random_ply_style(Random& random, const Polygons& mesh) {
  PlyStyle style;
  style.form = static_cast<PlyForm>(random.below(3));
  const auto highest = static_cast<double>(mesh.vertices.size());
  std::size_t longest = 0;
  for (const auto& polygon : mesh.faces) longest = std::max(longest, polygon.size());
  do style.index = ply_types.at(random.below(whole_types));
  while (largest_of(style.index) < highest);
  do style.count = ply_types.at(random.below(whole_types));
  while (largest_of(style.count) < static_cast<double>(longest));
  if (random.chance(0.4)) {  // what nearly every file has, and what has a fast way of its own
    style.index = PlyType::int32;
    style.count = PlyType::uint8;
  }
  const PlyType usual =
      random.one_of<PlyType>({PlyType::float32, PlyType::float64, PlyType::int16, PlyType::int32});
  for (PlyType& type : style.coordinate)
    type = random.chance(0.9) ? usual
                              : random.one_of<PlyType>({PlyType::int8, PlyType::int16,
                                                        PlyType::float32, PlyType::float64});
  style.list = random.chance(0.5) ? "vertex_index" : "vertex_indices";
  style.line_end = random.one_of<std::string>({"\n", "\n", "\r\n", "\r"});
  style.new_names = random.chance(0.5);
  style.faces_first = random.chance(0.2);
  if (random.chance(0.7)) style.ornaments = &random;
  return style;
}

Polygons as_stored(Polygons mesh, const PlyStyle& style) {
  for (Point& point : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = point[axis];
      with_type(style.coordinate[axis], x, [&x](auto number) { x = static_cast<double>(number); });
    }
  }
  return mesh;
}

}  // namespace winnow::test
