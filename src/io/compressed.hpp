// Looking through gzip and zstd.
#pragma once

#include "io/file_descriptor.hpp"

#include <memory>
#include <span>
#include <string>

namespace winnow {

// "gzip", "zstd" or "" by the first bytes of a content.
std::string compression_of(std::span<const std::byte> head);

// The plain content of `stream`. Reading throws Error(bad_input), naming `name`, where it is
// damaged or cut.
std::unique_ptr<ByteStream> decompress(Job& job, const std::string& name,
                                       const std::string& compression,
                                       std::unique_ptr<ByteStream> stream);

}  // namespace winnow
