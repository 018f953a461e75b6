// Runs of simplify() whose outputs are looked at.
#pragma once

#include <winnow/compare.hpp>
#include <winnow/simplify.hpp>

#include "support/files.hpp"
#include "support/refining.hpp"
#include "support/stl_file.hpp"

#include <string>
#include <vector>

namespace winnow::test {

struct RefinedFile {
  SimplifyReport report;
  PlainMesh mesh;
  std::string path;
};

// Written to `directory` as out.ply, over what is there.
inline RefinedFile refine_file(const Directory& directory, const std::string& input,
                               SimplifyOptions options) {
  Context context;
  context.threads = 2;
  context.scratch = directory.path();
  options.force = true;
  RefinedFile out;
  out.path = directory.file("out.ply");
  out.report = simplify(context, input, out.path, options);
  TestJob test;
  out.mesh = plain(welded(test.job, out.path));
  return out;
}

// The same of triangles.
inline RefinedFile refine_faces(const Directory& directory, const std::vector<Triangle>& faces,
                                const SimplifyOptions& options) {
  const std::string input = directory.file("in.stl");
  write_file(input, binary_stl(faces));
  return refine_file(directory, input, options);
}

inline SimplifyOptions to_faces(std::uint64_t faces) {
  SimplifyOptions options;
  options.target = Target::faces(faces);
  return options;
}

}  // namespace winnow::test
