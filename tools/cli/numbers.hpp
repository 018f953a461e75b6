// Numbers as the command line takes them and as people read them.
#pragma once

#include <winnow/simplify.hpp>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace winnow::cli {

// Fit for a terminal: what comes from a file or the command line may hold escape codes, line ends
// and names of kilobytes.
std::string clean(const std::string& text);

// All throw Error(usage), naming `option`.
std::uint64_t parse_count(const std::string& option,
                          const std::string& text);  // 250, 500k, 1.5M, 2G: thousands
std::uint64_t parse_size(const std::string& option,
                         const std::string& text);                        // 64M, 1.5G, 1GB, 1GiB
double parse_ratio(const std::string& option, const std::string& text);   // 0.01 or 1%
double parse_length(const std::string& option, const std::string& text);  // 2.5
// 0.5, in model units, or 0.1%, a part of the model's diagonal.
struct Distance {
  double value = 0;
  bool relative = false;
};
Distance parse_distance(const std::string& option, const std::string& text);
double parse_number(const std::string& option, const std::string& text,
                    const char* examples);  // the message says that it takes `examples`
// The low and the high corner of a box: 0,0,0,1,1,1
std::array<std::array<double, 3>, 2> parse_box(const std::string& option, const std::string& text);
std::array<double, 3> parse_triple(const std::string& option, const std::string& text,
                                   const char* examples);  // 1,-2,0.5

std::string show_count(std::uint64_t count);                   // 1,234,567
std::string show_list(const std::vector<std::string>& words);  // a, b
std::string show_bytes(std::uint64_t bytes);                   // 1.5 GiB
std::string show_rate(double per_second);                      // 45.2 M
std::string show_seconds(double seconds);                      // 0.45 s, 2 min 10 s
std::string show_length(double length, int digits = 6);        // significant ones
std::string show_place(const std::array<double, 3>& place, int digits = 6);
// Digits that tell these places in a model of this size as finely as if they were near the origin.
int digits_for(std::initializer_list<std::array<double, 3>> places, double size);

// "3 left out: 1 repeat a corner, 2 name a vertex that does not exist"
std::string show_bad_faces(const BadFaces& bad);

}  // namespace winnow::cli
