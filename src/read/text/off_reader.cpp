// OFF as text, as Geomview's manual describes it: a header, a vertex a line, a face a line. What
// stands behind the position (normal, colour, texture coordinates) is offered; what stands behind
// indices is passed over.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/formats.hpp"
#include "read/text/mesh.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>

namespace winnow {

namespace {

// "OFF", "COFF", "STCNOFF" ...; `behind` is what follows without a blank. Small letters are taken
// for capital ones, except an "n" before "OFF". By Geomview's manual it may be missing, so that a
// count comes first. Nothing if it is no such word.
struct Keyword {
  std::string prefix;
  std::string_view behind;
  bool missing = false;
};
std::optional<Keyword> keyword_of(std::string_view word) {
  std::string capital(word);
  std::transform(capital.begin(), capital.end(), capital.begin(), ascii_to_upper);
  const std::size_t at = capital.find("OFF");
  if (at == std::string_view::npos) {
    if (!parse_integer(word)) return {};
    return Keyword{{}, word, true};
  }
  Keyword found{std::string(word.substr(0, at)), word.substr(at + 3)};
  if (word.substr(at, 3) != "OFF") found.prefix = capital.substr(0, at);
  std::string_view left = found.prefix;
  for (const std::string_view part : {"ST", "C", "N", "4", "n"}) {
    if (left.starts_with(part)) left.remove_prefix(part.size());
  }
  const bool number = std::all_of(found.behind.begin(), found.behind.end(),
                                  [](char c) { return c >= '0' && c <= '9'; });
  if (!left.empty() || !number) return {};
  return found;
}

// What the header says of vertices. Behind the position stand normal, colour and texture
// coordinates, in this order.
struct Vertices {
  bool normals = false, colors = false, texture = false;
  std::uint64_t count = 0;
};

Vertices vertices_of(const Keyword& keyword) {
  const auto has = [&](std::string_view part) {
    return keyword.prefix.find(part) != std::string_view::npos;
  };
  return {has("N"), has("C"), has("ST"), 0};
}

// Reads the header alone, as far as it stands in `lines`; nothing is wrong with it yet.
Vertices vertices_of(TextLines& lines) {
  Vertices vertices;
  std::optional<Keyword> keyword;
  std::size_t found = 0;
  for (std::string_view line; found < 3 && lines.next(line);) {
    LineWords words(line);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      if (!keyword) {
        keyword = keyword_of(word);
        if (!keyword) return {};
        vertices = vertices_of(*keyword);
        word = keyword->behind;
        if (word.empty()) continue;
      }
      if (found++ == 0)
        vertices.count = static_cast<std::uint64_t>(parse_integer(word).value_or(0));
    }
    if (found == 2) ++found;  // some writers leave the edges out
  }
  return vertices;
}

// What only the numbers of the first vertices tell: how many a colour has, and whether they are
// whole, from 0 to 255. By Geomview's manual, colours of faces tell by their form alone whether
// they are whole. That is not said of vertices, where programs write reals from 0 to 1 also as "1 0
// 0 1". So whole numbers count as such only where one is above 1.
struct Colors {
  bool whole_lines = false;  // the first vertex has all that the keyword says
  std::size_t components = 0;
  bool bytes = false;
};

Colors colors_of(TextLines& lines, const Vertices& vertices) {
  Colors colors;
  const std::size_t before = vertices.normals ? 6 : 3;
  const std::size_t behind = vertices.texture ? 2 : 0;
  std::vector<std::string_view> words;
  std::uint64_t seen = 0;
  for (std::string_view line; seen < vertices.count && lines.next(line);) {
    LineWords of_line(line);
    words.clear();
    for (std::string_view word = of_line.next(); !word.empty(); word = of_line.next())
      words.push_back(word);
    if (words.empty()) continue;
    if (++seen == 1) {
      colors.whole_lines = words.size() >= before + behind;
      if (!colors.whole_lines || !vertices.colors) return colors;
      colors.components = words.size() - before - behind;
    }
    for (std::size_t i = before; i < words.size() && i < before + colors.components; ++i) {
      if (words[i].find_first_not_of("0123456789") != std::string_view::npos)
        return {true, colors.components, false};
      colors.bytes |= words[i] != "0" && words[i] != "1";
    }
  }
  return colors;
}

class OffParser {
 public:
  OffParser(ByteSource& source, std::size_t batch_faces, BufferedMesh& mesh)
      : source_(source), blocks_(mesh.job(), source, text_block_bytes(batch_faces)), mesh_(mesh) {}

  void parse() {
    read_header();
    check_size();
    for (vertices_next_ = true; left_ > 0 || vertices_next_;) {
      if (left_ > 0) {
        parse_text({[&](TextBlock& block) { return next(block); },
                    [&](const TextBlock& block, ParsedLines& lines) { parse_block(block, lines); }},
                   mesh_);
        if (left_ > 0) {
          throw Error(ErrorKind::bad_input,
                      "'" + source_.name() + "' ends " + grouped(left_) +
                          (vertices_next_ ? " vertices" : " faces") +
                          " short of what its header says: it was cut short, or the "
                          "counts are wrong");
        }
      }
      if (!vertices_next_) break;
      vertices_next_ = false;
      left_ = faces_;
    }
    read_to_the_end();
  }

 private:
  [[noreturn]] void fail(const TextBlock& block, std::string_view place,
                         const std::string& what) const {
    ParsedLines(block, mesh_).fail(place, what);
  }

  // The keyword and three counts, on as many lines as they take.
  void read_header() {
    TextBlock block;
    std::optional<Vertices> vertices;
    std::array<std::uint64_t, 3> counts{};
    std::size_t found = 0;
    while (found < counts.size() && blocks_.next(block)) {
      TextLines each(block.text());
      for (std::string_view line; found < counts.size() && each.next(line);) {
        LineWords words(line);
        for (std::string_view word = words.next(); !word.empty() && found < counts.size();
             word = words.next()) {
          if (!vertices) {
            const std::optional<Keyword> keyword = keyword_of(word);
            if (!keyword)
              fail(block, word, "expected 'OFF', not '" + std::string(word.substr(0, 40)) + "'");
            check_prefix(block, word, *keyword);
            if (keyword->missing) {
              mesh_.job().note("'" + source_.name() +
                               "' lacks the keyword 'OFF' and is read as OFF all the same");
            }
            vertices = vertices_of(*keyword);
            if (keyword->behind.empty()) continue;
            word = keyword->behind;
          }
          if (word == "BINARY" && found == 0) {
            fail(block, word,
                 "this is binary OFF, which is not read; convert it to OFF as text, or to PLY");
          }
          const std::optional<std::int64_t> count = parse_integer(word);
          if (!count || *count < 0)
            fail(block, word,
                 "'" + std::string(word.substr(0, 40)) +
                     "' is not a count of vertices, faces or edges");
          counts[found++] = static_cast<std::uint64_t>(*count);
        }
        // Some writers leave the edges out.
        if (found == 2) ++found;
        if (found == counts.size()) {
          const char* end = line.data() + line.size();
          blocks_.give_back(block, {end, static_cast<std::size_t>(block.text().data() +
                                                                  block.text().size() - end)});
        }
      }
    }
    if (found < counts.size()) {
      throw Error(ErrorKind::bad_input,
                  "'" + source_.name() + "' ends inside its OFF header: it was cut short");
    }
    left_ = counts[0];
    faces_ = counts[1];
    // What the keyword says and the first vertices do not bear out was not offered.
    const std::size_t normals = vertices->normals ? 3 : 0;
    if (vertices->colors && mesh_.carried().size() < normals + 3) {
      mesh_.pass_over("colours");
      if (vertices->texture) mesh_.pass_over("texture coordinates");
    }
  }

  void check_prefix(const TextBlock& block, std::string_view word, const Keyword& keyword) const {
    if (keyword.prefix.find('4') != std::string_view::npos ||
        keyword.prefix.find('n') != std::string_view::npos)
      fail(block, word, "this OFF has vertices of other than three dimensions, which is not read");
  }

  // A header that promises more than the file can hold: a vertex takes five characters and the end
  // of its line, a face takes one and that.
  void check_size() const {
    if (!source_.size()) return;
    const std::uint64_t rest = *source_.size() - source_.position() + 1;
    if (left_ > rest / 6 || faces_ > (rest - 6 * left_) / 2) {
      throw Error(ErrorKind::bad_input, "'" + source_.name() + "' is too short for its header of " +
                                            grouped(left_) + " vertices and " + grouped(faces_) +
                                            " faces: only " + human_bytes(rest - 1) +
                                            " follow; it was cut short, or the counts are wrong");
    }
  }

  // Lines of vertices, or lines of faces.
  bool next(TextBlock& block) {
    if (left_ == 0 || !blocks_.next(block)) return false;
    TextLines each(block.text());
    for (std::string_view line; left_ > 0 && each.next(line);) {
      if (LineWords(line).next().empty()) continue;
      if (--left_ > 0) continue;
      const char* end = line.data() + line.size();
      blocks_.give_back(
          block, {end, static_cast<std::size_t>(block.text().data() + block.text().size() - end)});
    }
    return true;
  }

  void parse_block(const TextBlock& block, ParsedLines& lines) const {
    TextLines each(block.text());
    for (std::string_view line; each.next(line);) {
      LineWords words(line);
      if (LineWords(line).next().empty()) continue;
      if (vertices_next_) {
        lines.add_position(words);
        lines.add_attributes(words, true);
        if (!words.next().empty()) lines.pass_over("numbers behind vertices");
      } else {
        parse_face(words, lines);
      }
    }
  }

  static void parse_face(LineWords& words, ParsedLines& lines) {
    const auto integer = [&] {
      const std::string_view word = words.next();
      const std::optional<std::int64_t> value = parse_integer(word);
      if (!value) lines.fail_number(word, words.rest());
      return *value;
    };
    for (std::int64_t count = integer(); count > 0; --count) {
      const std::int64_t vertex = integer();
      lines.add_corner(vertex < 0 ? -1 : vertex, false);
    }
    lines.end_face();
    if (!words.next().empty()) lines.pass_over("colours of faces");
  }

  // A pipe's writer must not be cut off.
  void read_to_the_end() {
    while (!source_.take(std::size_t{1} << 16).bytes.empty())
      mesh_.job().progress.check_cancelled();
  }

  ByteSource& source_;
  TextBlocks blocks_;
  BufferedMesh& mesh_;
  std::uint64_t left_ = 0;  // lines of the kind at work
  std::uint64_t faces_ = 0;
  bool vertices_next_ = false;
};

void parse_off(ByteSource& source, std::size_t batch_faces, BufferedMesh& mesh) {
  OffParser(source, batch_faces, mesh).parse();
}

TextMatch match_off(std::string_view head) {
  TextLines each(head);
  std::optional<Keyword> keyword;
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    std::string_view word = words.next();
    if (word.empty()) continue;
    if (!keyword) {
      keyword = keyword_of(word);
      if (!keyword) return TextMatch::none;
      word = keyword->behind.empty() ? words.next() : keyword->behind;
      if (word.empty()) continue;
    }
    if (word != "BINARY" && !parse_integer(word)) return TextMatch::none;
    if (!keyword->missing) return TextMatch::first;
    // Three counts or two, alone in their line.
    std::size_t counts = 1;
    for (word = words.next(); !word.empty(); word = words.next(), ++counts) {
      if (!parse_integer(word)) return TextMatch::none;
    }
    return counts == 2 || counts == 3 ? TextMatch::named : TextMatch::none;
  }
  // Cut behind its keyword, which the reader tells.
  return keyword ? TextMatch::first : TextMatch::none;
}

AvailableAttributes offer_of_off(std::string_view head) {
  AvailableAttributes offer;
  TextLines each(head);
  Vertices vertices = vertices_of(each);
  const auto add = [&](const std::vector<const char*>& names, NumberType type) {
    for (const char* name : names) offer.scalars.push_back({name, type});
  };
  const Colors colors = colors_of(each, vertices);
  if (!colors.whole_lines) return offer;
  if (vertices.normals) add({"nx", "ny", "nz"}, NumberType::float32);
  if (vertices.colors) {
    if (colors.components < 3 || colors.components > 4) return offer;
    const NumberType type = colors.bytes ? NumberType::uint8 : NumberType::float32;
    add({"red", "green", "blue"}, type);
    if (colors.components == 4) add({"alpha"}, type);
  }
  if (vertices.texture) add({"s", "t"}, NumberType::float32);
  return offer;
}

std::unique_ptr<MeshReader> open_off(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish,
                                     bool /*asked*/) {
  const AvailableAttributes offer = offer_of_off(first_lines(*source));
  return std::make_unique<BufferedReader>(job, std::move(source), memory, wish,
                                          facts_of(Format::off).name, offer, parse_off);
}

}  // namespace

const InputFormat off_input{.reading = Reading::whole,
                            .open = open_off,
                            .probe = probe_by_lines<offer_of_off>,
                            .certain =
                                [](std::string_view head) {
                                  return head.substr(0, 16).find("OFF BINARY") !=
                                         std::string_view::npos;
                                },
                            .match = match_off};

}  // namespace winnow
