// Whether two names are of one file.
#pragma once

#include <string>

namespace winnow {

// The files need not exist. An empty name is no file's.
bool same_place(const std::string& one, const std::string& other);

}  // namespace winnow
