// Every mesh of a folder of real and of broken meshes ends in an output that is sound, or in one
// clear refusal with a documented exit code.
#include "meshes.hpp"
#include "support/program.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace {

using namespace winnow::test;
namespace fs = std::filesystem;

std::vector<fs::path> meshes_in(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 7> endings{".ply", ".stl", ".obj", ".off",
                                                      ".m",   ".glb", ".gltf"};
    if (entry.is_regular_file() &&
        std::find(endings.begin(), endings.end(), ending) != endings.end())
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  // The frames of a sequence are alike: the first of each ten.
  std::erase_if(found, [](const fs::path& mesh) {
    const std::string name = mesh.stem().string();
    return mesh.string().find("/D_sequences/") != std::string::npos && name.back() != '1';
  });
  return found;
}

void check_sound(const std::string& output) {
  const auto json = winnow_ok({"info", output, "--json"}).json();
  CHECK(json["faces"] > 0);
  CHECK(json["bad_faces"]["degenerate"] == 0);
  CHECK(json["bad_faces"]["non_finite"] == 0);
  CHECK(json["bad_faces"]["out_of_range"] == 0);
}

}  // namespace

TEST_CASE("every mesh at hand ends in a sound output or a documented refusal", "[census]") {
  const std::string folder = WINNOW_MESHES;
  if (folder.empty()) {
    std::cout << "skipped: needs -DWINNOW_MESHES=<folder of meshes>\n";
    return;
  }
  const fs::path place =
      fs::temp_directory_path() / ("winnow-census-" + std::to_string(::getpid()));
  fs::create_directories(place);
  const std::string output = place / "small.ply";
  for (const fs::path& mesh : meshes_in(folder)) {
    for (const std::vector<std::string>& fineness :
         {std::vector<std::string>{"--grid", "64"}, {"--ratio", "10%"}}) {
      INFO(mesh);
      fs::remove(output);
      const Run run = run_winnow({"simplify", mesh, "-o", output, fineness[0], fineness[1], "-q"});
      INFO(run.err);
      CHECK(run.signal == 0);
      if (run.code == 0) {
        check_sound(output);
      } else {
        // Not a mesh, no face in it, cut short: 3. A mesh all of which falls into too few cells: 1.
        CHECK((run.code == 3 || run.code == 1));
        CHECK(run.err.starts_with("winnow: "));
        CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
        CHECK_FALSE(fs::exists(output));
      }
    }
  }
  fs::remove_all(place);
}
