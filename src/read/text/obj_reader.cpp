// Wavefront OBJ, by its specification ("Advanced Visualizer Manual, Appendix B1", 1993): vertices
// and faces; everything else is passed over.
#include <winnow/error.hpp>

#include "read/formats.hpp"
#include "read/text/mesh.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace winnow {

namespace {

// "7", "7/1", "7/1/3" or "7//3": what is behind the first number is of textures and normals.
void add_corner(std::string_view word, ParsedLines& lines) {
  const char* end = word.data() + word.size();
  std::int64_t number = 0;
  const auto [behind, error] =
      std::from_chars(word.data() + (word.front() == '+' ? 1 : 0), end, number);
  if (error == std::errc::invalid_argument || (behind != end && *behind != '/'))
    lines.fail(word, "'" + std::string(word.substr(0, 40)) + "' is not a corner of a face");
  if (error == std::errc::result_out_of_range || number == 0) number = INT64_MIN / 4;
  if (number > 0) return lines.add_corner(number - 1, false);
  lines.add_corner(lines.vertices() + number, true);
}

// Numbers behind the position that are a colour.
constexpr std::array<const char*, 4> components{"red", "green", "blue", "alpha"};

void parse_obj_lines(const TextBlock& block, bool colors, ParsedLines& lines) {
  TextLines each(block.text());
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    const std::string_view keyword = words.next();
    if (keyword == "v") {
      lines.add_position(words);
      if (colors) {
        lines.add_attributes(words, false);
      } else if (!words.next().empty() && !words.next().empty()) {
        lines.pass_over(colors_of_some);  // one number alone is a weight
      }
    } else if (keyword == "f") {
      for (std::string_view word = words.next(); !word.empty(); word = words.next())
        add_corner(word, lines);
      lines.end_face();
    } else if (keyword == "vn") {
      lines.pass_over("normals");
    } else if (keyword == "vt") {
      lines.pass_over("texture coordinates");
    } else if (keyword == "usemtl") {
      lines.pass_over("materials");
    } else if (keyword.empty() && line.starts_with("#MRGB")) {
      lines.pass_over("colours in #MRGB comments");
    }
  }
}

// What may stand before the first vertex or face.
constexpr std::array<std::string_view, 14> prelude{
    "g",      "o", "s", "mtllib",     "usemtl",    "mg",  "usemap",
    "maplib", "l", "p", "shadow_obj", "trace_obj", "lod", "bevel"};

bool is_geometry(std::string_view keyword) {
  return keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "vp" || keyword == "f";
}

// Also "7/1/3", and "1,5", of which the reader tells what is wrong.
bool looks_like_number(std::string_view word) {
  return parse_real(word) || has_decimal_comma(word) ||
         (!word.empty() && word.front() != '/' && word.find('/') != std::string_view::npos);
}

void parse_obj(ByteSource& source, std::size_t batch_faces, BufferedMesh& mesh) {
  TextBlocks blocks(mesh.job(), source, text_block_bytes(batch_faces));
  const bool colors = !mesh.carried().empty();
  parse_text(
      {[&](TextBlock& block) { return blocks.next(block); },
       [&](const TextBlock& block, ParsedLines& lines) { parse_obj_lines(block, colors, lines); }},
      mesh);
}

TextMatch match_obj(std::string_view head) {
  TextLines each(head);
  TextMatch match = TextMatch::first;
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    const std::string_view keyword = words.next();
    if (keyword.empty() || std::find(prelude.begin(), prelude.end(), keyword) != prelude.end())
      continue;
    if (is_geometry(keyword)) {
      // Prose may have a number behind a "v".
      std::size_t numbers = 0;
      while (looks_like_number(words.next())) ++numbers;
      if (numbers >= (match == TextMatch::first ? 1 : 3)) return match;
    }
    match = TextMatch::later;
  }
  return TextMatch::none;
}

AvailableAttributes offer_of_obj(std::string_view head) {
  AvailableAttributes offer;
  TextLines each(head);
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    if (words.next() != "v") continue;
    std::size_t numbers = 0;
    while (!words.next().empty()) ++numbers;
    if (numbers == 6 || numbers == 7) {
      for (std::size_t i = 0; i < numbers - 3; ++i)
        offer.scalars.push_back({components.at(i), NumberType::float32});
    }
    break;
  }
  return offer;
}

std::unique_ptr<MeshReader> open_obj(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish,
                                     bool /*asked*/) {
  const AvailableAttributes offer = offer_of_obj(first_lines(*source));
  return std::make_unique<BufferedReader>(job, std::move(source), memory, wish,
                                          facts_of(Format::obj).name, offer, parse_obj);
}

}  // namespace

const InputFormat obj_input{.reading = Reading::whole,
                            .open = open_obj,
                            .probe = probe_by_lines<offer_of_obj>,
                            .match = match_obj};

}  // namespace winnow
