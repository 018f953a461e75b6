// A content put together of a text and of spools.
#pragma once

#include "io/byte_source.hpp"
#include "io/spool.hpp"

#include <memory>
#include <string>
#include <vector>

namespace winnow {

// Reads like a file: `head`, then the spools, which are finished, one after the other.
std::unique_ptr<ByteSource> spooled_source(std::string name, std::string head,
                                           std::vector<std::unique_ptr<Spool>> spools);

}  // namespace winnow
