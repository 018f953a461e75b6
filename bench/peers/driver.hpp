// What every bench program needs around its work: arguments, a stopwatch, one line of JSON.
#pragma once

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bench {

// "PROGRAM A B --name value --flag": positional arguments in order, options by name. Options in
// `flags` take no value.
class Arguments {
 public:
  Arguments(int argc, char** argv, const std::vector<std::string>& flags,
            const std::vector<std::string>& options) {
    const auto in = [](const std::vector<std::string>& list, const std::string& word) {
      for (const auto& item : list) {
        if (item == word) return true;
      }
      return false;
    };
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (in(flags, word)) {
        options_[word] = "yes";
      } else if (in(options, word)) {
        if (++i == argc) throw std::runtime_error(word + " needs a value");
        options_[word] = argv[i];
      } else if (word.starts_with("--")) {
        throw std::runtime_error("unknown option " + word);
      } else {
        files_.push_back(word);
      }
    }
  }

  const std::vector<std::string>& files() const { return files_; }
  bool has(const std::string& name) const { return options_.contains(name); }

  std::string text(const std::string& name, const std::string& otherwise) const {
    const auto found = options_.find(name);
    return found == options_.end() ? otherwise : found->second;
  }

  // A number with an optional suffix: 500k, 31M, 1G, 1%.
  double number(const std::string& name, double otherwise) const {
    if (!has(name)) return otherwise;
    const std::string word = options_.at(name);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const std::string_view suffix(end, static_cast<std::size_t>(word.data() + word.size() - end));
    if (suffix == "k") value *= 1e3;
    if (suffix == "M") value *= 1e6;
    if (suffix == "G") value *= 1e9;
    if (suffix == "%") value /= 100;
    const bool known =
        suffix.empty() || suffix == "k" || suffix == "M" || suffix == "G" || suffix == "%";
    if (error != std::errc() || !known || !(value > 0)) {
      throw std::runtime_error(name + ": not a positive number: " + word);
    }
    return value;
  }

  // The faces asked for with --faces or --ratio.
  std::uint64_t target_faces(std::uint64_t faces_in) const {
    if (has("--faces")) return static_cast<std::uint64_t>(number("--faces", 0));
    if (has("--ratio")) return static_cast<std::uint64_t>(number("--ratio", 0) * double(faces_in));
    throw std::runtime_error("say --faces N or --ratio R");
  }

 private:
  std::vector<std::string> files_;
  std::map<std::string, std::string> options_;
};

class Stopwatch {
 public:
  // Seconds since the construction or the last lap.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Builds one JSON object. Names and texts are the program's own or file names without control
// characters.
class Json {
 public:
  Json& add(const std::string& name, const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    return put(name, quoted + '"');
  }
  Json& add(const std::string& name, const char* text) { return add(name, std::string(text)); }
  Json& add(const std::string& name, const Json& object) { return put(name, object.str()); }
  Json& add(const std::string& name, double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return put(name, std::isfinite(value) ? digits : "null");
  }
  template <class Integer>
  requires std::is_integral_v<Integer> Json& add(const std::string& name, Integer value) {
    return put(name, std::to_string(value));
  }

  std::string str() const { return '{' + body_ + '}'; }
  void print() const { std::printf("%s\n", str().c_str()); }

 private:
  Json& put(const std::string& name, const std::string& value) {
    body_ += (body_.empty() ? "\"" : ", \"") + name + "\": " + value;
    return *this;
  }

  std::string body_;
};

// What a peer reports. Finding the right parameter is kept apart: a user knows it or pays for it.
struct Report {
  std::uint64_t faces_in = 0, faces_out = 0;
  double read = 0, simplify = 0, write = 0;

  Json json() const {
    return Json()
        .add("faces_in", faces_in)
        .add("faces_out", faces_out)
        .add("seconds_read", read)
        .add("seconds_simplify", simplify)
        .add("seconds_write", write)
        .add("seconds_total", read + simplify + write);
  }
};

// The number of cells along the longest side that makes `count(cells)` come close to `target`.
// Clustering a surface gives faces in proportion to cells², so each trial is scaled by the square
// root of what it missed.
template <class Count>
double find_cells(double target, Count count) {
  double cells = std::max(1.0, std::sqrt(target / 6));
  double best = cells, best_miss = HUGE_VAL;
  for (int trial = 0; trial < 8; ++trial) {
    const double faces = std::max(1.0, double(count(cells)));
    const double miss = std::abs(std::log(faces / target));
    if (miss < best_miss) {
      best = cells;
      best_miss = miss;
    }
    if (miss < 0.01) break;
    cells *= std::sqrt(target / faces);
  }
  return best;
}

// Runs a program's body; a failure is one line on stderr and exit code 1.
template <class Body>
int guarded(const char* program, Body body) {
  try {
    body();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return 1;
  }
}

}  // namespace bench
