#include "support/attributes.hpp"

#include "read/ply/scalar.hpp"
#include "support/files.hpp"
#include "support/program.hpp"
#include "support/sources.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace winnow::test {

namespace {

std::string stored(double value, NumberType type, PlyForm form) {
  std::array<std::byte, 8> bytes{};
  if (std::isfinite(value)) {
    store_rounded(value, type, bytes.data());
  } else if (type == NumberType::float32) {
    const auto single = static_cast<float>(value);
    std::memcpy(bytes.data(), &single, sizeof single);
  } else {
    std::memcpy(bytes.data(), &value, sizeof value);
  }
  if (form == PlyForm::ascii) {
    std::array<char, 64> text{};
    const double number = load_real(bytes.data(), type, false);
    std::snprintf(text.data(), text.size(), "%.17g ", number);
    return text.data();
  }
  std::string out(reinterpret_cast<const char*>(bytes.data()), size_of(type));
  if (form == PlyForm::big_endian) std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace

AttributedMesh read_attributed(const std::string& path) {
  const std::string content = bytes_of_file(path);
  MemorySource source(content);
  const PlyHeader header = read_ply_header(source);
  REQUIRE(header.form == PlyForm::little_endian);
  const auto* at = reinterpret_cast<const std::byte*>(content.data()) + header.bytes;
  AttributedMesh mesh;
  const PlyElement& vertex = *header.find("vertex");
  for (const PlyProperty& property : vertex.properties)
    mesh.properties.push_back(std::string(name_of(property.type)) + " " + property.name);
  for (std::uint64_t v = 0; v < vertex.count; ++v) {
    Point& position = mesh.positions.emplace_back();
    for (const PlyProperty& property : vertex.properties) {
      const double value = load_real(at, property.type, false);
      at += size_of(property.type);
      if (property.name.size() == 1 && property.name[0] >= 'x') {
        position.at(static_cast<std::size_t>(property.name[0] - 'x')) = value;
      } else {
        mesh.columns[property.name].push_back(value);
      }
    }
  }
  for (std::uint64_t f = 0; f < header.find("face")->count; ++f, at += 13)
    std::memcpy(mesh.faces.emplace_back().data(), at + 1, 12);
  return mesh;
}

void write_attributed(const std::string& path, const AttributedMesh& mesh,
                      const std::vector<Column>& columns, PlyForm form) {
  std::ofstream out(path, std::ios::binary);
  constexpr std::array forms{"ascii", "binary_little_endian", "binary_big_endian"};
  const bool text = form == PlyForm::ascii;
  out << "ply\nformat " << forms.at(static_cast<std::size_t>(form)) << " 1.0\nelement vertex "
      << mesh.positions.size() << "\nproperty float x\nproperty float y\nproperty float z\n";
  for (const Column& column : columns)
    out << "property " << name_of(column.type) << " " << column.name << "\n";
  out << "element face " << mesh.faces.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& position : mesh.positions) {
    for (const double x : position) out << stored(x, NumberType::float32, form);
    for (const Column& column : columns) out << stored(column.value(position), column.type, form);
    if (text) out << "\n";
  }
  for (const auto& face : mesh.faces) {
    out << stored(3, NumberType::uint8, form);
    for (const std::uint32_t corner : face) out << stored(corner, NumberType::int32, form);
    if (text) out << "\n";
  }
}

AttributedMesh generated(const std::string& directory, std::uint64_t faces) {
  const std::string path = directory + "/generated.ply";
  generate("scan", faces, path);
  AttributedMesh mesh = read_attributed(path);
  ::unlink(path.c_str());
  return mesh;
}

std::vector<Column> usual_columns() {
  const auto wave = [](double a, double b) {
    return [a, b](const Point& p) {
      return 0.5 + 0.5 * std::sin(a * p[0] + b * p[1] + (a - b) * p[2]);
    };
  };
  const auto times = [](double factor, const auto& value) {
    return [factor, value](const Point& p) { return factor * value(p); };
  };
  return {{"red", NumberType::uint8, times(255, wave(3, 20))},
          {"green", NumberType::uint8, times(255, wave(31, 7))},
          {"blue", NumberType::uint8, times(255, wave(2, 9))},
          {"quality", NumberType::float32, times(1e-20, wave(60, 50))},
          {"label", NumberType::int32, times(2e9, wave(5, 1))},
          {"stamp", NumberType::float64, times(1e200, wave(4, 4))}};
}

double mean_over_surface(const AttributedMesh& mesh, const std::string& column,
                         const std::function<double(double)>& mean) {
  const std::vector<double>& numbers = mesh.columns.at(column);
  double sum = 0;
  double total = 0;
  for (const auto& face : mesh.faces) {
    const double area = length(
        doubled_area({mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]}));
    total += area;
    for (const std::uint32_t corner : face) sum += area / 3 * mean(numbers[corner]);
  }
  return sum / total;
}

}  // namespace winnow::test
