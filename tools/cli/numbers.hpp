// Numbers as the command line takes them and as people read them.
#pragma once

#include <winnow/simplify.hpp>
#include <winnow/text.hpp>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace winnow::cli {

// Fit for a terminal: what comes from a file or the command line may hold escape codes, line ends
// and names of kilobytes.
std::string clean(const std::string& text);
// JSON of the same value, in which what a terminal would not show is escaped.
std::string escaped_json(const std::string& json);

std::string show_list(const std::vector<std::string>& words);  // a, b
std::string show_rate(double per_second);                      // 45.2 M
std::string show_seconds(double seconds);                      // 0.45 s, 2 min 10 s
std::string show_length(double length, int digits = 6);        // significant ones
std::string show_place(const std::array<double, 3>& place, int digits = 6);
// Digits that tell these places in a model of this size as finely as if they were near the origin.
int digits_for(std::initializer_list<std::array<double, 3>> places, double size);

// "3 left out: 1 repeat a corner, 2 name a vertex that does not exist"
std::string show_bad_faces(const BadFaces& bad);
std::string show_resumed(const Resumed& resumed);  // what had been done before

}  // namespace winnow::cli
