// Several files as one mesh.
#pragma once

#include "read/mesh_reader.hpp"

#include <string>
#include <vector>

namespace winnow {

// Faces and positions of all files in their order, numbered through. One file is open at a time, so
// that many take no more memory than one; each is opened again in each pass. Throws Error(usage)
// for what is no regular file and so cannot be read twice. Attributes are carried that all files
// offer under one name and of one type; of files without vertices nothing is asked.
std::unique_ptr<MeshReader> join_files(Job& job, const std::vector<std::string>& names,
                                       Format format, const ReaderMemory& memory,
                                       const AttributeRequest& wish = {});

// The same, from the first bytes of each.
InputProbe look_at_files(Job& job, const std::vector<std::string>& names, Format format,
                         const AttributeRequest& wish = {});

// What the readers of these files take of the budget besides, decompressing them: the most of any.
std::uint64_t memory_to_open(Job& job, const std::vector<std::string>& names);

}  // namespace winnow
