#include "io/manifest.hpp"

#include <winnow/error.hpp>

#include "base/checksum.hpp"
#include "base/text.hpp"

#include <charconv>
#include <span>
#include <string_view>

namespace winnow {

namespace {

constexpr std::string_view title = "winnow checkpoint 1\n";
constexpr std::string_view sum_key = "checksum ";

std::string sum_line(std::string_view lines) {
  return std::string(sum_key) + std::to_string(Checksum::of(std::as_bytes(std::span(lines)))) +
         "\n";
}

// File names may hold line ends.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
    } else {
      if (c == '\\') out += '\\';
      out += c;
    }
  }
  return out;
}

std::string plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
    } else {
      ++i;
      out += text[i] == 'n' ? '\n' : text[i];
    }
  }
  return out;
}

template <typename Number>
Number number_of(const std::string& text, const std::string& key, const std::string& path) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    damaged_checkpoint(path, "'" + key + "' is no number");
  return number;
}

}  // namespace

void damaged_checkpoint(const std::string& path, const std::string& what) {
  throw Error(ErrorKind::bad_input,
              "'" + path + "' is damaged: " + what +
                  "; remove the checkpoint's directory and run the command again");
}

void Manifest::set(const std::string& key, double number) {
  values_[key] = shortest(number);
}

const std::string& Manifest::text(const std::string& key) const {
  const auto found = values_.find(key);
  if (found == values_.end()) damaged_checkpoint(path_, "'" + key + "' is missing");
  return found->second;
}

std::uint64_t Manifest::number(const std::string& key) const {
  return number_of<std::uint64_t>(text(key), key, path_);
}

double Manifest::real(const std::string& key) const {
  return number_of<double>(text(key), key, path_);
}

std::string Manifest::print() const {
  std::string lines(title);
  for (const auto& [key, value] : values_)
    lines.append(key).append(" ").append(escaped(value)).append("\n");
  return lines + sum_line(lines);
}

Manifest Manifest::parse(const std::string& text, const std::string& path) {
  if (!text.starts_with(title))
    damaged_checkpoint(path, "it is no manifest of a winnow checkpoint");
  const std::size_t last = text.rfind("\n" + std::string(sum_key));
  if (last == std::string::npos || text.substr(last + 1) != sum_line(text.substr(0, last + 1)))
    damaged_checkpoint(path, "its checksum does not fit");
  Manifest manifest;
  manifest.path_ = path;
  std::string_view lines(text);
  lines = lines.substr(title.size(), last + 1 - title.size());
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(line.size() + 1);
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) damaged_checkpoint(path, "a line has no value");
    manifest.values_[std::string(line.substr(0, space))] = plain(line.substr(space + 1));
  }
  return manifest;
}

}  // namespace winnow
