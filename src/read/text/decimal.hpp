// Decimal numbers of formats that do not say how exact theirs are.
#pragma once

#include <string_view>

namespace winnow {

// Whether the nearest float says the same as `word`, to the last digit that stands there: what a
// program writes of floats does, coordinates of a map with millimetres do not. `value` is the
// double that `word` reads as. A double's own last digits ("-0.037829700000000001") do not count.
bool float_says_it(std::string_view word, double value);

}  // namespace winnow
