// .m, the text format of Hugues Hoppe's mesh programs: "Vertex 7 x y z" and "Face 1 7 9 12", each
// with a number of its own and attributes in braces, which are passed over.
#include "read/formats.hpp"
#include "read/text/mesh.hpp"
#include "read/text/tokens.hpp"

namespace winnow {

namespace {

std::int64_t integer(std::string_view word, LineWords& words, const ParsedLines& lines) {
  const std::optional<std::int64_t> value = parse_integer(word);
  if (!value) lines.fail_number(word, words.rest());
  return *value;
}

void parse_m_lines(const TextBlock& block, ParsedLines& lines) {
  TextLines each(block.text());
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    const std::string_view keyword = words.next();
    if (keyword == "Vertex") {
      const std::string_view word = words.next();
      const std::int64_t number = integer(word, words, lines);
      if (number < 0 || number >= no_vertex)
        lines.fail(word, "the vertex number " + std::string(word.substr(0, 40)) +
                             " is not between 0 and 2^32");
      lines.add_number(static_cast<std::uint32_t>(number));
      lines.add_position(words);
      if (!words.next().empty()) lines.pass_over("attributes of vertices");
    } else if (keyword == "Face") {
      integer(words.next(), words, lines);
      std::string_view word = words.next();
      for (; !word.empty() && word.front() != '{'; word = words.next())
        lines.add_corner(integer(word, words, lines), false);
      if (!word.empty()) lines.pass_over("attributes of faces");
      lines.end_face();
    }
  }
}

void parse_m(ByteSource& source, std::size_t batch_faces, BufferedMesh& mesh) {
  TextBlocks blocks(mesh.job(), source, text_block_bytes(batch_faces));
  parse_text({[&](TextBlock& block) { return blocks.next(block); }, parse_m_lines}, mesh);
}

TextMatch match_m(std::string_view head) {
  TextLines each(head);
  TextMatch match = TextMatch::first;
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    const std::string_view keyword = words.next();
    if (keyword.empty()) continue;
    if ((keyword == "Vertex" || keyword == "Face") && parse_integer(words.next())) return match;
    match = TextMatch::later;
  }
  return TextMatch::none;
}

std::unique_ptr<MeshReader> open_m(Job& job, std::unique_ptr<ByteSource> source,
                                   const ReaderMemory& memory, const AttributeRequest& wish,
                                   bool /*asked*/) {
  return std::make_unique<BufferedReader>(job, std::move(source), memory, wish,
                                          facts_of(Format::m).name, AvailableAttributes{}, parse_m);
}

}  // namespace

const InputFormat m_input{.reading = Reading::whole, .open = open_m, .match = match_m};

}  // namespace winnow
