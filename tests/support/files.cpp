#include "support/files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <zstd.h>

namespace winnow::test {

namespace fs = std::filesystem;

Directory::Directory() {
  const char* temporary = std::getenv("TMPDIR");
  std::string name =
      std::string(temporary != nullptr && *temporary != '\0' ? temporary : "/var/tmp") +
      "/winnow-test-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no temporary directory like " + name);
  path_ = name;
}

Directory::~Directory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Directory::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

bool exists(const std::string& path) {
  return fs::exists(fs::symlink_status(path));
}
std::uint64_t size_of_file(const std::string& path) {
  return fs::file_size(path);
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path);
}

std::string hash_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::uint64_t hash = 0xcbf29ce484222325;
  std::vector<char> part(1 << 16);
  while (in.read(part.data(), static_cast<std::streamsize>(part.size())) || in.gcount() > 0) {
    for (std::streamsize i = 0; i < in.gcount(); ++i) {
      hash = (hash ^ static_cast<unsigned char>(part[static_cast<std::size_t>(i)])) * 0x100000001b3;
    }
  }
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
  return text;
}

std::string gzip_file(const std::string& path) {
  namespace bio = boost::iostreams;
  std::ifstream in(path, std::ios::binary);
  bio::filtering_istreambuf packed;
  packed.push(bio::gzip_compressor(bio::gzip_params(1)));
  packed.push(in);
  std::ofstream out(path + ".gz", std::ios::binary);
  bio::copy(packed, out);
  return path + ".gz";
}

std::string zstd_file(const std::string& path) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     ZSTD_freeCCtx);
  std::ifstream in(path, std::ios::binary);
  std::ofstream out(path + ".zst", std::ios::binary);
  std::vector<char> plain(1 << 17);
  std::vector<char> packed(1 << 17);
  bool last = false;
  while (!last) {
    in.read(plain.data(), static_cast<std::streamsize>(plain.size()));
    last = in.gcount() < static_cast<std::streamsize>(plain.size());
    ZSTD_inBuffer from{plain.data(), static_cast<std::size_t>(in.gcount()), 0};
    for (std::size_t left = 1; left != 0 && (last || from.pos < from.size);) {
      ZSTD_outBuffer into{packed.data(), packed.size(), 0};
      left = ZSTD_compressStream2(context.get(), &into, &from, last ? ZSTD_e_end : ZSTD_e_continue);
      if (ZSTD_isError(left) != 0) throw std::runtime_error("zstd failed");
      out.write(packed.data(), static_cast<std::streamsize>(into.pos));
    }
  }
  return path + ".zst";
}

namespace {

template <typename Number>
void put(std::string& text, Number value, char behind) {
  std::array<char, 64> digits{};
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  text += behind;
}

void put_point(std::string& text, std::istream& in) {
  std::array<float, 3> xyz{};
  in.read(reinterpret_cast<char*>(xyz.data()), sizeof xyz);
  put(text, xyz[0], ' ');
  put(text, xyz[1], ' ');
  put(text, xyz[2], '\n');
}

void flush_large(std::ofstream& out, std::string& text) {
  if (text.size() < (1 << 16)) return;
  out << text;
  text.clear();
}

// What stands around the numbers of vertices and faces.
struct TextForm {
  std::string header, vertex, face;
  bool numbered = false;  // vertices and faces have numbers of their own
  std::uint32_t first = 0;
};

TextForm form_of(const std::string& path, const std::string& header, std::uint64_t vertices,
                 std::uint64_t faces) {
  if (path.ends_with(".obj")) return {"# as text\n", "v ", "f ", false, 1};
  if (path.ends_with(".m")) return {"# as text\n", "Vertex ", "Face ", true, 1};
  if (path.ends_with(".off")) {
    return {"OFF\n" + std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n", "", "3 "};
  }
  return {header, "", "3 "};
}

void ascii_ply(std::istream& in, std::ofstream& out, const std::string& path) {
  std::string text;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("format")) line = "format ascii 1.0";
    if (line.starts_with("element vertex ")) vertices = std::stoull(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoull(line.substr(13));
    text += line + "\n";
    if (line == "end_header") break;
  }
  const TextForm form = form_of(path, text, vertices, faces);
  text = form.header;
  for (std::uint64_t i = 0; i < vertices; ++i) {
    text += form.vertex;
    if (form.numbered) put(text, i + 1, ' ');
    put_point(text, in);
    flush_large(out, text);
  }
  for (std::uint64_t i = 0; i < faces; ++i) {
    std::array<std::uint32_t, 3> corner{};
    if (in.get() != 3) throw std::runtime_error("not a triangle of winnow generate");
    in.read(reinterpret_cast<char*>(corner.data()), sizeof corner);
    text += form.face;
    if (form.numbered) put(text, i + 1, ' ');
    put(text, corner[0] + form.first, ' ');
    put(text, corner[1] + form.first, ' ');
    put(text, corner[2] + form.first, '\n');
    flush_large(out, text);
  }
  out << text;
}

void ascii_stl(std::istream& in, std::ofstream& out) {
  std::string text = "solid surface\n";
  in.seekg(80);
  std::uint32_t faces = 0;
  in.read(reinterpret_cast<char*>(&faces), sizeof faces);
  for (std::uint32_t i = 0; i < faces; ++i) {
    text += "facet normal ";
    put_point(text, in);
    text += "outer loop\n";
    for (int corner = 0; corner < 3; ++corner) {
      text += "vertex ";
      put_point(text, in);
    }
    text += "endloop\nendfacet\n";
    in.ignore(2);
    flush_large(out, text);
  }
  out << text + "endsolid surface\n";
}

}  // namespace

std::string ascii_file(const std::string& path, const std::string& ascii_path) {
  std::ifstream in(path, std::ios::binary);
  std::ofstream out(ascii_path, std::ios::binary);
  if (path.ends_with(".stl")) {
    ascii_stl(in, out);
  } else {
    ascii_ply(in, out, ascii_path);
  }
  out.close();
  if (!in || !out) throw std::runtime_error("cannot turn " + path + " into text");
  return ascii_path;
}

std::string glb_file(const std::string& path, const std::string& glb_path) {
  std::ifstream in(path, std::ios::binary);
  std::ofstream out(glb_path, std::ios::binary);
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    if (line.starts_with("element vertex ")) vertices = std::stoull(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoull(line.substr(13));
  }
  const auto number = [](std::uint64_t value) { return std::to_string(value); };
  std::string json =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + number(12 * (vertices + faces)) +
      R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + number(12 * vertices) +
      R"(},{"buffer":0,"byteOffset":)" + number(12 * vertices) + R"(,"byteLength":)" +
      number(12 * faces) +
      R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
      number(vertices) + R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
      number(3 * faces) +
      R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("nodes":[{"mesh":0}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto put_word = [&out](std::uint64_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    out.write(reinterpret_cast<const char*>(&word), sizeof word);
  };
  out << "glTF";
  put_word(2);
  put_word(28 + json.size() + 12 * (vertices + faces));
  put_word(json.size());
  out << "JSON" << json;
  put_word(12 * (vertices + faces));
  out.write("BIN\0", 4);
  std::array<char, 12> record{};
  for (std::uint64_t i = 0; i < vertices + faces; ++i) {
    if (i >= vertices && in.get() != 3)
      throw std::runtime_error("not a triangle of winnow generate");
    in.read(record.data(), record.size());
    out.write(record.data(), record.size());
  }
  out.close();
  if (!in || !out) throw std::runtime_error("cannot turn " + path + " into a GLB");
  return glb_path;
}

std::string faces_first_file(const std::string& path, const std::string& other_path) {
  const std::string whole = bytes_of_file(path);
  const std::string end = "end_header\n";
  const std::size_t body = whole.find(end) + end.size();
  const std::size_t vertex = whole.find("element vertex ");
  const std::size_t face = whole.find("element face ");
  const std::size_t vertex_bytes = 12 * std::stoull(whole.substr(vertex + 15));
  write_file(other_path, whole.substr(0, vertex) + whole.substr(face, body - end.size() - face) +
                             whole.substr(vertex, face - vertex) + end +
                             whole.substr(body + vertex_bytes) + whole.substr(body, vertex_bytes));
  return other_path;
}

}  // namespace winnow::test
