// Several targets of one call: their order, and the names of what is made for them.
#pragma once

#include <winnow/simplify.hpp>

#include <string>
#include <vector>

namespace winnow {

// Whether `a` asks for a finer result than `b`, which is of the same kind. Between a length and a
// part of the diagonal neither is finer.
bool is_finer(const Target& a, const Target& b);

// The target and the coarser ones.
std::vector<Target> targets_of(const SimplifyOptions& options);

// As an option takes it: "100000", "0.1", "0.5%".
std::string text_of(const Target& target);

// `output` with {faces}, {ratio} or {error} replaced by what each target asks for. Throws
// Error(usage) where the names of several would not differ.
std::vector<std::string> output_names(const std::string& output, const SimplifyOptions& options);

// The same of SimplifyOptions::map; no names where no map is asked for.
std::vector<std::string> map_names(const SimplifyOptions& options);

}  // namespace winnow
