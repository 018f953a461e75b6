#include "read/ply/header.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/formats.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>

namespace winnow {

namespace {

struct TypeName {
  std::string_view old_name, new_name;
  PlyType type;
};
constexpr std::array<TypeName, 8> type_names{{{"char", "int8", PlyType::int8},
                                              {"uchar", "uint8", PlyType::uint8},
                                              {"short", "int16", PlyType::int16},
                                              {"ushort", "uint16", PlyType::uint16},
                                              {"int", "int32", PlyType::int32},
                                              {"uint", "uint32", PlyType::uint32},
                                              {"float", "float32", PlyType::float32},
                                              {"double", "float64", PlyType::float64}}};

// No header that anybody writes is longer; without a limit a wrong file would be read to its end.
constexpr std::size_t longest_header = std::size_t{1} << 20;

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  return line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
}

// In any case, as other readers take it.
bool is_magic(std::string_view line) {
  constexpr std::string_view magic = "ply";
  const std::string_view word = trimmed(line);
  return std::equal(word.begin(), word.end(), magic.begin(), magic.end(),
                    [](char c, char want) { return ascii_to_lower(c) == want; });
}

class HeaderParser {
 public:
  explicit HeaderParser(ByteSource& source) : source_(source) {}

  PlyHeader parse() {
    pass_over_mark();
    std::string_view first = next_line();
    while (trimmed(first).empty()) first = next_line();
    if (!is_magic(first)) fail("does not begin with 'ply'");
    bool has_format = false;
    for (;;) {
      const std::string_view line = next_line();
      const std::vector<std::string_view> words = split(line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      // They would end up in messages.
      if (std::any_of(line.begin(), line.end(), is_control)) fail("has bytes that are no text");
      if (words[0] == "end_header") break;
      if (words[0] == "format") {
        parse_format(words);
        has_format = true;
      } else if (words[0] == "element") {
        parse_element(words);
      } else if (words[0] == "property") {
        parse_property(words);
      } else {
        fail("has an unknown keyword '" + std::string(words[0].substr(0, 40)) + "'");
      }
    }
    if (!has_format) fail("names no format before its end");
    header_.bytes = at_;
    source_.take(at_);
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, "'" + source_.name() + "': the PLY header, line " +
                                          std::to_string(line_) + ", " + what);
  }

  std::string_view next_line() {
    ++line_;
    for (std::size_t scanned = at_;; ++scanned) {
      if (scanned == text_.size() && !more()) fail("ends before 'end_header'");
      if (text_[scanned] != '\n' && text_[scanned] != '\r') continue;
      const std::string_view line(text_.data() + at_, scanned - at_);
      // Lines end in LF, CR LF, or, from old programs, CR alone.
      if (text_[scanned] == '\r') {
        const bool more_to_see = scanned + 1 < text_.size() || more();
        if (more_to_see && text_[scanned + 1] == '\n' && !lone_returns_) {
          ++scanned;
        } else if (line_ == 1) {
          lone_returns_ = true;
        }
      }
      const std::size_t begin = at_;
      at_ = scanned + 1;
      return std::string_view(text_).substr(begin, line.size());
    }
  }

  void pass_over_mark() {
    more();
    at_ = text_.size() - without_byte_order_mark(text_).size();
  }

  bool more() {
    if (text_.size() >= longest_header) fail("does not end within " + human_bytes(longest_header));
    const Block block = source_.peek(std::max<std::size_t>(2 * text_.size(), 4096));
    if (block.bytes.size() == text_.size()) return false;
    text_.assign(reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size());
    return true;
  }

  static bool is_control(char c) {
    return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f';
  }

  static std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::string_view blanks = " \t";
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
      words.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(blanks, end);
    }
    return words;
  }

  void parse_format(const std::vector<std::string_view>& words) {
    const std::string_view form = words.size() > 1 ? words[1] : "";
    if (form == "ascii") {
      header_.form = PlyForm::ascii;
    } else if (form == "binary_little_endian") {
      header_.form = PlyForm::little_endian;
    } else if (form == "binary_big_endian") {
      header_.form = PlyForm::big_endian;
    } else {
      fail("names an unknown format '" + std::string(form.substr(0, 40)) + "'");
    }
  }

  void parse_element(const std::vector<std::string_view>& words) {
    if (words.size() < 3) fail("declares an element without a name or a count");
    PlyElement element;
    element.name = words[1];
    if (!names_.insert(element.name).second)
      fail("declares the element '" + std::string(words[1].substr(0, 40)) + "' a second time");
    const auto [end, error] =
        std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
    // Beyond 2^48 nothing can be stored, and sizes in bytes would no longer fit into 64 bits.
    if (error != std::errc{} || end != words[2].data() + words[2].size() ||
        element.count >> 48 != 0) {
      fail("declares an impossible count '" + std::string(words[2].substr(0, 40)) + "'");
    }
    header_.elements.push_back(std::move(element));
  }

  PlyType parse_type(std::string_view word) const {
    for (const TypeName& type : type_names) {
      if (word == type.old_name || word == type.new_name) return type.type;
    }
    fail("uses an unknown type '" + std::string(word.substr(0, 40)) + "'");
  }

  void parse_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) fail("declares a property before any element");
    PlyProperty property;
    property.list = words.size() > 1 && words[1] == "list";
    if (words.size() < (property.list ? 5U : 3U))
      fail("declares a property without a type or a name");
    if (property.list) {
      property.count_type = parse_type(words[2]);
      if (!is_integer(property.count_type)) fail("counts a list with " + std::string(words[2]));
    }
    property.type = parse_type(words[property.list ? 3 : 1]);
    property.name = words[property.list ? 4 : 2];
    header_.elements.back().properties.push_back(std::move(property));
  }

  ByteSource& source_;
  PlyHeader header_;
  std::set<std::string> names_;  // of elements
  std::string text_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  bool lone_returns_ = false;
};

}  // namespace

const PlyProperty* PlyElement::find(const std::string& property) const {
  for (const PlyProperty& candidate : properties) {
    if (candidate.name == property) return &candidate;
  }
  return nullptr;
}

bool PlyElement::fixed_size() const {
  return std::none_of(properties.begin(), properties.end(),
                      [](const PlyProperty& p) { return p.list; });
}

std::size_t PlyElement::smallest_size() const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties)
    size += size_of(property.list ? property.count_type : property.type);
  return size;
}

const PlyElement* PlyHeader::find(const std::string& element) const {
  for (const PlyElement& candidate : elements) {
    if (candidate.name == element) return &candidate;
  }
  return nullptr;
}

bool begins_like_ply(std::string_view head) {
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return false;
  const std::size_t end = head.find_first_of("\r\n", begin);
  return end != std::string_view::npos && is_magic(head.substr(begin, end - begin));
}

PlyHeader read_ply_header(ByteSource& source) {
  return HeaderParser(source).parse();
}

}  // namespace winnow
