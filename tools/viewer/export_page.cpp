#include "viewer/export_page.hpp"

#include <winnow/error.hpp>

#include "viewer/page.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>

#include <fcntl.h>
#include <unistd.h>

namespace winnow::viewer {

namespace {

// A file that gets its name when it is whole; else nothing is left of it.
class NewFile {
 public:
  NewFile(const std::string& name, bool force) : name_(name), part_(name + ".part") {
    if (!force && ::access(name.c_str(), F_OK) == 0)
      throw Error(ErrorKind::usage, "'" + name + "' exists already; `force` replaces it");
    fd_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd_ < 0) fail();
  }
  ~NewFile() {
    if (fd_ < 0) return;
    ::close(fd_);
    ::unlink(part_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t done = ::write(fd_, text.data(), text.size());
      if (done < 0 && errno == EINTR) continue;
      if (done < 0) fail();
      text.remove_prefix(static_cast<std::size_t>(done));
    }
  }
  void finish() {
    if (::fsync(fd_) != 0 || std::rename(part_.c_str(), name_.c_str()) != 0) fail();
    ::close(fd_);
    fd_ = -1;
  }

 private:
  [[noreturn]] void fail() const {
    const int why = errno;
    if (fd_ >= 0) {
      ::close(fd_);
      ::unlink(part_.c_str());
    }
    throw Error(ErrorKind::resources, "'" + name_ + "' cannot be written: " + std::strerror(why));
  }

  std::string name_, part_;
  int fd_ = -1;
};

// Of a number of bytes that 3 divides, or of the last ones.
void put_base64(std::span<const char> bytes, std::string& out) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group <<= 8;
      if (k < count) group |= static_cast<unsigned char>(bytes[i + k]);
    }
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= count ? letters[group >> (18 - 6 * k) & 63] : '=';
  }
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '&')
      out += "&amp;";
    else if (letter == '"')
      out += "&quot;";
    else if (letter == '<')
      out += "&lt;";
    else
      out += letter;
  }
  return out;
}

void write_file(const Context& context, const ShownFile& file, NewFile& out) {
  constexpr std::size_t at_once = std::size_t{3} << 16;
  std::vector<char> bytes(at_once);
  std::string text;
  for (std::uint64_t at = 0; at < file.bytes(); at += at_once) {
    if (context.cancelled()) throw Error(ErrorKind::cancelled, "interrupted");
    const std::size_t got = file.read(at, bytes);
    if (got < std::min<std::uint64_t>(at_once, file.bytes() - at))
      throw Error(ErrorKind::bad_input, "'" + file.shown() + "' was shortened meanwhile");
    text.clear();
    put_base64(std::span(bytes).first(got), text);
    out.write(text);
  }
}

}  // namespace

void export_page(const Context& context, std::string_view page, const std::vector<ShownFile>& files,
                 const std::string& output, bool force) {
  for (const ShownFile& file : files) {
    if (file.bytes() > most_exported_bytes)
      throw Error(ErrorKind::usage,
                  "'" + file.shown() + "' has " + std::to_string(file.bytes()) +
                      " bytes, and a page can hold " + std::to_string(most_exported_bytes) +
                      "; fewer `bits` make it smaller, or put it beside the page on a web server");
  }
  NewFile out(output, force);
  const std::size_t mark = page.find(mesh_mark);
  out.write(page.substr(0, mark));
  for (const ShownFile& file : files) {
    out.write(R"(<script type="application/base64" data-mesh=")" + escaped(file.shown()) + R"(">)");
    write_file(context, file, out);
    out.write("</script>\n");
  }
  out.write(page.substr(mark + mesh_mark.size()));
  out.finish();
}

}  // namespace winnow::viewer
