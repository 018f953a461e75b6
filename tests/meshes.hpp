// Where the tests find meshes.
#pragma once

#include <filesystem>
#include <iostream>
#include <string>

namespace winnow::test {

// A file of tests/data.
inline std::string test_data(const std::string& name) {
  return std::string(WINNOW_TEST_DATA) + '/' + name;
}

// A file of the folder of larger meshes that CMake's WINNOW_MESHES names. Where that is not given
// or lacks the file, says so in the words by which ctest counts the test as skipped, and returns an
// empty string:
//   const std::string mesh = large_mesh("A_classic/rabbit.obj");
//   if (mesh.empty()) return;
inline std::string large_mesh(const std::string& name) {
  const std::string folder = WINNOW_MESHES;
  if (folder.empty()) {
    std::cout << "skipped: " << name << " needs -DWINNOW_MESHES=<folder of meshes>\n";
    return {};
  }
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  if (!std::filesystem::exists(path)) {
    std::cout << "skipped: " << path << " does not exist\n";
    return {};
  }
  return path;
}

}  // namespace winnow::test
