// Headers as programs write them.
#include "read/ply/header.hpp"
#include "support/job.hpp"
#include "support/ply_file.hpp"
#include "support/reading.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"

#include <chrono>

#include <catch2/catch.hpp>

namespace winnow {

namespace {

PlyHeader header_of(const std::string& text) {
  test::MemorySource source(text);
  PlyHeader header = read_ply_header(source);
  CHECK(source.position() == header.bytes);
  return header;
}

std::string lines(const std::string& text, const std::string& end) {
  std::string out;
  for (const char c : text) out += c == '\n' ? end : std::string(1, c);
  return out;
}

const std::string plain =
    "ply\nformat binary_little_endian 1.0\ncomment a comment\nobj_info made by hand\nelement "
    "vertex "
    "3\nproperty float x\n"
    "property float y\nproperty double z\nproperty list uchar int flags\nelement face 1\nproperty "
    "list uchar "
    "uint vertex_index\n"
    "end_header\n";

void check_plain(const PlyHeader& header) {
  CHECK(header.form == PlyForm::little_endian);
  REQUIRE(header.elements.size() == 2);
  const PlyElement& vertex = header.elements[0];
  CHECK(vertex.name == "vertex");
  CHECK(vertex.count == 3);
  REQUIRE(vertex.properties.size() == 4);
  CHECK(vertex.find("y")->type == PlyType::float32);
  CHECK(vertex.find("z")->type == PlyType::float64);
  CHECK_FALSE(vertex.find("z")->list);
  CHECK(vertex.find("flags")->list);
  CHECK(vertex.find("flags")->count_type == PlyType::uint8);
  CHECK(vertex.find("nothing") == nullptr);
  CHECK_FALSE(vertex.fixed_size());
  CHECK(vertex.smallest_size() == 4 + 4 + 8 + 1);
  CHECK(header.find("face")->count == 1);
  CHECK(header.find("face")->find("vertex_index")->type == PlyType::uint32);
  CHECK(header.find("edge") == nullptr);
}

}  // namespace

TEST_CASE("a header ends right before the data, whatever its lines end in") {
  // The data begin with what could be taken for a line end.
  for (const std::string data : {"", "\n", "\r", "\r\n", "\n\r", "xyz"}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      CAPTURE(data.size(), end.size());
      if (end == "\r" && data.empty()) continue;
      const std::string text = lines(plain, end);
      const PlyHeader header = header_of(text + data);
      check_plain(header);
      // Where the lines end in a lone return, or in a lone feed, the next byte is data.
      CHECK(header.bytes == text.size());
    }
  }
}

TEST_CASE("blanks, tabs, empty lines and remarks anywhere do not matter") {
  const std::string text =
      "ply\n\n  format \t binary_little_endian   1.0 \ncomment\ncomment element face 77\nobj_info "
      "end_header\n\telement vertex 3  \n"
      "property float x\ncomment between\nproperty float  y\nproperty double z\nobj_info\nproperty "
      "list "
      "uchar int flags\n   \n"
      "element face 1 more words\nproperty list uchar uint vertex_index and more\nend_header\n";
  check_plain(header_of(text));
}

TEST_CASE("old and new type names are the same types") {
  for (std::size_t i = 0; i < test::ply_types.size(); ++i) {
    const PlyType type = test::ply_types.at(i);
    for (const bool new_names : {false, true}) {
      const std::string name = test::type_name(type, new_names);
      const PlyHeader header =
          header_of("ply\nformat ascii 1.0\nelement e 1\nproperty " + name + " p\nend_header\n");
      CAPTURE(name);
      CHECK(header.elements[0].properties[0].type == type);
      CHECK(size_of(type) == header.elements[0].smallest_size());
    }
    CHECK(std::string(name_of(type)) == test::type_name(type, false));
    CHECK(is_integer(type) == (i < test::whole_types));
  }
}

TEST_CASE("a header longer than one block is read whole") {
  for (const std::size_t remarks : {50, 100, 500, 5000}) {
    std::string text = plain;
    std::string block;
    for (std::size_t i = 0; i < remarks; ++i)
      block += "comment remark number " + std::to_string(i) + " of a long list of them\n";
    text.insert(text.find("element face"), block);
    CAPTURE(remarks);
    check_plain(header_of(text + "data"));
    check_plain(header_of(lines(text, "\r\n") + "data"));
  }
}

TEST_CASE("a header cut anywhere is an error") {
  for (std::size_t length = 0; length < plain.size() - 1; ++length) {
    CAPTURE(length);
    REQUIRE(test::error_of([&] { header_of(plain.substr(0, length)); }).kind() ==
            ErrorKind::bad_input);
  }
}

TEST_CASE("a header of very many elements or properties takes linear time") {
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n";
  const std::string list = "property list uchar int vertex_indices\n";
  std::string elements, properties;
  for (int i = 0; i < 55'000; ++i) {
    elements += "element " + std::to_string(i) + " 0\n";
    properties += "property int " + std::to_string(i) + "\n";
  }
  const std::string body = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  const auto begin = std::chrono::steady_clock::now();
  CHECK(
      test::faces_of(vertices + "element face 1\n" + list + elements + body + "3 0 1 2\n").size() ==
      1);
  CHECK(test::faces_of(vertices + "element face 0\n" + properties + list + body).empty());
  // Ten seconds when each name was looked for among all.
  if (!test::sanitized) CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
}

TEST_CASE("a wrong header is refused with the line that is wrong") {
  struct Wrong {
    std::string from, to;
    int line;
  };
  for (const Wrong& wrong :
       std::vector<Wrong>{{"ply\n", "plx\n", 1},
                          {"binary_little_endian", "binary_middle_endian", 2},
                          {"format binary_little_endian 1.0", "format", 2},
                          {"element vertex 3", "element vertex", 5},
                          {"element vertex 3", "element vertex -3", 5},
                          {"element vertex 3", "element vertex 3.5", 5},
                          {"element vertex 3", "element vertex three", 5},
                          {"element vertex 3", "element vertex 9223372036854775808", 5},
                          {"element vertex 3", "element vertex 18446744073709551616", 5},
                          {"element vertex 3", "element vertex 281474976710656", 5},
                          {"element vertex 3\n", "", 5},
                          {"property float y", "property quad y", 7},
                          {"property float y", "property float", 7},
                          {"property float y", "property", 7},
                          {"property float y", "properties float y", 7},
                          {"list uchar int", "list float int", 9},
                          {"list uchar int", "list double int", 9},
                          {"list uchar int", "list uchar in\x1bt", 9},
                          {"element vertex", "element ver\x01tex", 5},
                          {"element face", "element fa\x7f", 10},
                          {"list uchar int flags", "list uchar int", 9}}) {
    std::string text = plain;
    text.replace(text.find(wrong.from), wrong.from.size(), wrong.to);
    CAPTURE(text);
    const Error error = test::error_of([&] { header_of(text); });
    CHECK(error.kind() == ErrorKind::bad_input);
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(message.find("line " + std::to_string(wrong.line) + ",") != std::string::npos);
  }
  std::string text = plain;
  text.erase(text.find("format"), text.find("comment") - text.find("format"));
  CHECK(test::error_of([&] { header_of(text); }).kind() == ErrorKind::bad_input);
}

}  // namespace winnow
