// What the header of a progressive file says.
#pragma once

#include <winnow/progressive.hpp>

#include "io/byte_source.hpp"
#include "io/job.hpp"

#include <string>

namespace winnow {

// `source`: of which nothing was taken yet. `input`: its name.
ProgressiveInfo info_of_progressive(Job& job, ByteSource& source, const std::string& input);

}  // namespace winnow
