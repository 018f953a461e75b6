#include "viewer/export_page.hpp"

#include <winnow/error.hpp>

#include "io/byte_source.hpp"
#include "viewer/page.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include <sys/stat.h>
#include <unistd.h>

namespace winnow::viewer {

namespace {

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

}  // namespace

ExportedPage::ExportedPage(Context& context, const std::string& output, bool force,
                           const std::vector<std::string>& inputs)
    : job_(context), sink_(job_, output, force) {
  for (const std::string& input : inputs) {
    struct stat status {};
    const bool there =
        input == "-" ? ::fstat(STDIN_FILENO, &status) == 0 : ::stat(input.c_str(), &status) == 0;
    if (there) refuse_output(job_, FileNumber::of(status), input);
  }
}

void ExportedPage::write(std::string_view page, const std::vector<ShownFile>& files) {
  for (const ShownFile& file : files) {
    if (file.bytes() > most_exported_bytes)
      throw Error(ErrorKind::usage,
                  "'" + file.shown() + "' has " + std::to_string(file.bytes()) +
                      " bytes, and a page can hold " + std::to_string(most_exported_bytes) +
                      "; fewer `bits` make it smaller, or put it beside the page on a web server");
  }
  const std::size_t mark = page.find(mesh_mark);
  put(page.substr(0, mark));
  for (const ShownFile& file : files) {
    put(R"(<script type="application/base64" data-mesh=")" + escaped(file.shown()) + R"(">)");
    put_file(file);
    put("</script>\n");
  }
  put(page.substr(mark + mesh_mark.size()));
  sink_.finish();
}

void ExportedPage::put(std::string_view text) {
  sink_.write(std::as_bytes(std::span(text)));
}

void ExportedPage::put_file(const ShownFile& file) {
  constexpr std::size_t at_once = std::size_t{3} << 16;
  std::vector<char> bytes(at_once);
  std::string text;
  for (std::uint64_t at = 0; at < file.bytes(); at += at_once) {
    job_.progress.check_cancelled();
    const std::size_t got = file.read(at, bytes);
    if (got < std::min<std::uint64_t>(at_once, file.bytes() - at))
      throw Error(ErrorKind::bad_input, "'" + file.shown() + "' was shortened meanwhile");
    text.clear();
    put_base64(std::span(bytes).first(got), text);
    put(text);
  }
}

}  // namespace winnow::viewer
