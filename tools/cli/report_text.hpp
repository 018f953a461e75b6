// What the reports of several commands say alike, as JSON and as lines for people.
#pragma once

#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "program.hpp"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace winnow::cli {

using Json = nlohmann::ordered_json;

// Names in it may come from a file: what is no UTF-8 becomes the sign for that, and what a terminal
// would obey is escaped.
std::string text_of(const Json& json);

// What every report begins with, the version, the command and the options as they were given, and
// `body`.
Json report_of(const CLI::App& command, const Json& body);
// What stands for `body` where there is none.
Json json_of_error(const std::string& message, ErrorKind kind);
void print(const Json& body, const CommonOptions& common, std::ostream& out);

// The report of a command that failed; to standard output, unless that was to get a mesh.
void print_failure(const CLI::App& app, const std::string& message, ErrorKind kind);

// Lines of a name and what is said of it, which begins in the same column.
class Lines {
 public:
  Lines(std::ostream& out, std::size_t column) : out_(out), column_(column) {}

  void operator()(const std::string& name, const std::string& text) const;
  void notes(const std::vector<std::string>& notes) const;

 private:
  std::ostream& out_;
  std::size_t column_;
};

// "3 pieces (area 0.25), 1 handle"; empty where nothing was lost.
std::string show_lost(const LevelReport::Lost& lost);

// Where positions were rounded to whole numbers.
void show_quantized(const Lines& line, double position_error);

// "0.45 s  (12 Mfaces/s)"
std::string show_time(double seconds, std::uint64_t faces);
// "12 MiB at its peak, and 3 MiB of scratch"
std::string show_memory(std::uint64_t peak, std::uint64_t scratch);

}  // namespace winnow::cli
