// STL files, binary and ASCII.
#pragma once

#include "support/polygons.hpp"

#include <charconv>
#include <cstring>
#include <string>
#include <vector>

namespace winnow::test {

using Triangle = std::array<Point, 3>;

struct BinaryStlStyle {
  std::string header = "made for a test";
  std::int64_t count = -1;  // below 0: the right one
  std::string trailing = "";
  std::uint16_t attribute = 0x3eef;  // of each face
};

inline std::string binary_stl(const std::vector<Triangle>& faces,
                              const BinaryStlStyle& style = {}) {
  std::string text = style.header;
  text.resize(80, ' ');
  const auto put = [&text](auto number) {
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  put(static_cast<std::uint32_t>(style.count < 0 ? static_cast<std::int64_t>(faces.size())
                                                 : style.count));
  for (const Triangle& face : faces) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (const Point& corner : face) {
      for (const double x : corner) put(static_cast<float>(x));
    }
    put(style.attribute);
  }
  return text + style.trailing;
}

struct AsciiStlStyle {
  std::string name = "test";
  std::string line_end = "\n";
  std::string indent = "  ";
  bool upper_case = false;
  bool end = true;  // the last line
};

inline std::string float_text(double value) {
  std::array<char, 64> buffer{};
  return {
      buffer.data(),
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), static_cast<float>(value)).ptr};
}

inline std::string ascii_stl(const std::vector<Triangle>& faces, const AsciiStlStyle& style = {}) {
  std::string text;
  const auto word = [&style](std::string words) {
    for (char& c : words) {
      if (style.upper_case && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return words;
  };
  const std::string& end = style.line_end;
  text += word("solid ") + style.name + end;
  for (const Triangle& face : faces) {
    text += style.indent + word("facet normal") + " 0 0 1" + end + style.indent +
            word("outer loop") + end;
    for (const Point& p : face) {
      text += style.indent + word("vertex ") + float_text(p[0]) + " " + float_text(p[1]) + " " +
              float_text(p[2]) + end;
    }
    text += style.indent + word("endloop") + end + style.indent + word("endfacet") + end;
  }
  if (style.end) text += word("endsolid ") + style.name + end;
  return text;
}

// Corners that a float holds.
inline std::vector<Triangle> random_triangles(Random& random, std::size_t count,
                                              double half = 100) {
  std::vector<Triangle> faces(count);
  for (Triangle& face : faces) {
    for (Point& corner : face) {
      for (double& x : corner) x = static_cast<float>(random.real(-half, half));
    }
  }
  return faces;
}

inline std::vector<SeenFace> as_seen(const std::vector<Triangle>& faces) {
  std::vector<SeenFace> seen;
  for (const Triangle& face : faces) seen.push_back({FaceStatus::good, face});
  return seen;
}

}  // namespace winnow::test
