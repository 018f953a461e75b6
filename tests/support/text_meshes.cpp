#include "support/text_meshes.hpp"

#include <charconv>

namespace winnow::test {

namespace {

std::string number(double value) {
  std::array<char, 64> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

// Words of a line, with blanks of any kind between and something behind.
class LineWriter {
 public:
  explicit LineWriter(const TextStyle& style, bool joins = false) : style_(style), joins_(joins) {}

  std::string line(const std::vector<std::string>& words, const std::string& comment = "") const {
    std::string text;
    for (const std::string& word : words) {
      if (!text.empty()) text += between();
      text += word;
    }
    if (style_.random != nullptr && style_.random->chance(0.1)) text = "  " + text + " \t";
    if (style_.random != nullptr && style_.random->chance(0.1)) text += comment;
    return text + style_.line_end;
  }

  // Between records.
  std::string nothing() const {
    if (style_.random == nullptr || !style_.random->chance(0.1)) return "";
    return style_.random->one_of<std::string>({"", "# v 1 2 3", " \t", "#"}) + style_.line_end;
  }

 private:
  std::string between() const {
    if (style_.random == nullptr) return " ";
    if (joins_ && style_.random->chance(0.05)) return " \\" + style_.line_end + " ";
    return style_.random->one_of<std::string>({" ", "  ", "\t", " "});
  }

  const TextStyle& style_;
  bool joins_;
};

std::vector<std::string> position(const std::string& keyword, const Point& p) {
  std::vector<std::string> words;
  if (!keyword.empty()) words.push_back(keyword);
  for (const double x : p) words.push_back(number(x));
  return words;
}

std::string obj_corner(std::int64_t index, std::int64_t written, Random* random) {
  if (index < 0) return "0";
  // Relative ones count back from the vertices so far.
  std::string corner = random != nullptr && index < written && random->chance(0.3)
                           ? std::to_string(index - written)
                           : std::to_string(index + 1);
  if (random != nullptr)
    corner += random->one_of<std::string>({"", "/1", "/1/2", "//3", "/-1/-1", "/", "//"});
  return corner;
}

}  // namespace

std::string obj_file(const Polygons& mesh, const TextStyle& style) {
  Random* random = style.random;
  const LineWriter writer(style);
  const LineWriter joining(style, true);
  std::string text = writer.line({"# made for a test"});
  std::size_t vertex = 0;
  std::size_t face = 0;
  while (vertex < mesh.vertices.size() || face < mesh.faces.size()) {
    text += writer.nothing();
    const bool other = random != nullptr && random->chance(0.1);
    if (other) {
      text += writer.line(random->one_of<std::vector<std::string>>({{"vt", "0.5", "0.5"},
                                                                    {"vn", "0", "0", "1"},
                                                                    {"g", "v", "f"},
                                                                    {"o", "f", "1", "2", "3"},
                                                                    {"usemtl", "stone"},
                                                                    {"mtllib", "stones.mtl"},
                                                                    {"s", "off"},
                                                                    {"l", "1", "2"}}));
    }
    const bool vertex_next = random == nullptr || face == mesh.faces.size()
                                 ? vertex < mesh.vertices.size()
                                 : vertex < mesh.vertices.size() && random->chance(0.5);
    if (vertex_next) {
      std::vector<std::string> words = position("v", mesh.vertices[vertex++]);
      if (random != nullptr && random->chance(0.3)) words.emplace_back("1.0");
      if (random != nullptr && words.size() == 4 && random->chance(0.3))
        words.insert(words.end(), {"0.25", "0.5", "nan"});
      text += joining.line(words, "# a vertex");
    } else if (face < mesh.faces.size()) {
      std::vector<std::string> words{"f"};
      for (const std::int64_t index : mesh.faces[face++])
        words.push_back(obj_corner(index, static_cast<std::int64_t>(vertex), random));
      text += joining.line(words, "# a face");
    }
  }
  return text;
}

std::string off_file(const Polygons& mesh, const TextStyle& style, const std::string& keyword) {
  Random* random = style.random;
  const LineWriter writer(style);
  const std::vector<std::string> counts{std::to_string(mesh.vertices.size()),
                                        std::to_string(mesh.faces.size()), "0"};
  std::string text = writer.nothing();
  if (random != nullptr && random->chance(0.5)) {
    std::vector<std::string> words{keyword};
    words.insert(words.end(), counts.begin(), counts.end());
    text += writer.line(words);
  } else {
    text += writer.line({keyword}) + writer.nothing() + writer.line(counts, "# counts");
  }
  for (const Point& p : mesh.vertices) {
    std::vector<std::string> words = position("", p);
    if (keyword != "OFF") words.insert(words.end(), {"0.5", "0.25", "1"});
    text += writer.nothing() + writer.line(words, "# a vertex");
  }
  for (const auto& face : mesh.faces) {
    std::vector<std::string> words{std::to_string(face.size())};
    for (const std::int64_t index : face) words.push_back(std::to_string(index));
    if (random != nullptr && random->chance(0.3)) words.insert(words.end(), {"255", "0", "0"});
    text += writer.nothing() + writer.line(words, "# a face");
  }
  return text;
}

std::string m_file(const Polygons& mesh, const TextStyle& style) {
  Random* random = style.random;
  const LineWriter writer(style);
  std::vector<std::uint64_t> names(mesh.vertices.size());
  std::uint64_t next = 1;
  for (std::uint64_t& name : names) {
    name = next;
    next += random != nullptr && random->chance(0.2) ? random->between(1, 50) : 1;
  }
  if (random != nullptr && random->chance(0.5)) random->shuffle(names);
  std::string text;
  std::size_t vertex = 0;
  std::size_t face = 0;
  while (vertex < mesh.vertices.size() || face < mesh.faces.size()) {
    text += writer.nothing();
    const bool vertex_next =
        vertex < mesh.vertices.size() &&
        (random == nullptr || face == mesh.faces.size() || random->chance(0.5));
    if (vertex_next) {
      std::vector<std::string> words = position("", mesh.vertices[vertex]);
      words.insert(words.begin(), {"Vertex", std::to_string(names[vertex])});
      if (random != nullptr && random->chance(0.3))
        words.emplace_back("{normal=(0 0 1) rgb=(1 0 0)}");
      ++vertex;
      text += writer.line(words);
    } else {
      std::vector<std::string> words{"Face", std::to_string(face + 1)};
      for (const std::int64_t index : mesh.faces[face]) {
        words.push_back(index < 0 ? std::to_string(next + 7)
                                  : std::to_string(names[static_cast<std::size_t>(index)]));
      }
      if (random != nullptr && random->chance(0.3)) words.emplace_back("{matid=3}");
      ++face;
      text += writer.line(words);
    }
  }
  return text;
}

Polygons as_floats(Polygons mesh) {
  for (Point& p : mesh.vertices) {
    for (double& x : p) x = static_cast<float>(x);
  }
  return mesh;
}

}  // namespace winnow::test
