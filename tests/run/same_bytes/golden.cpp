// Outputs have not changed since they were last looked at: golden.txt beside this file. Whoever
// changes a result on purpose renews it, looks at what changed and why, and commits it with the
// change:
//   build/release/tests/run_tests "renew the golden outputs"
#include "support/attributes.hpp"
#include "support/simplified.hpp"

#include <fstream>
#include <iterator>
#include <map>

namespace winnow::test {

namespace {

std::string golden_path() {
  return std::string(WINNOW_TEST_DATA) + "/../run/same_bytes/golden.txt";
}

// What is run, by a name: the surfaces of `winnow generate` and the two meshes of tests/data.
std::map<std::string, std::string> current() {
  const Directory directory;
  std::map<std::string, std::string> inputs;
  for (const char* surface : {"scan", "terrain", "part"}) {
    for (const char* format : {".ply", ".stl"}) {
      const std::string name = std::string(surface) + format;
      generate(surface, 30'000, inputs[name] = directory.file(name), {.seed = 7});
    }
  }
  generate("terrain", 30'000, inputs["far.ply"] = directory.file("far.ply"),
           {.offset = {431000, 5412000, 300}});
  for (const char* name : {"whale_cranium.ply.zst", "white_mountains.ply.zst"}) {
    inputs[name] = std::string(WINNOW_TEST_DATA) + "/" + name;
  }
  std::map<std::string, std::string> found;
  for (const auto& [name, path] : inputs) {
    for (const Words& options :
         {Words{"--grid", "60"}, Words{"--grid", "60", "--placement", "quadric", "--normals"},
          Words{"--faces", "3000", "--refine", "none"},
          Words{"--ratio", "0.5", "--refine", "none"}}) {
      const Words placed = joined(options).find("--placement") == std::string::npos
                               ? options + Words{"--placement", "mean"}
                               : options;
      found[name + " " + joined(placed)] = simplified(directory, path, placed).hash;
    }
    found[name + " --grid 60 --placement mean --to stl"] =
        simplified(directory, path, {"--grid", "60", "--placement", "mean"}, {}, "out.stl").hash;
  }
  for (const char* name : {"scan.ply", "scan.stl", "far.ply"}) {
    found[std::string(name) + " --cell 0.05 --placement mean"] =
        simplified(directory, inputs[name], {"--cell", "0.05", "--placement", "mean"}).hash;
  }
  // Refined: by every target, cost and way, clustered first and not.
  for (const auto& [name, path] : inputs) {
    for (const Words& options :
         {Words{"--faces", "1000"}, Words{"--faces", "1000", "--detail", "6"},
          Words{"--ratio", "40%"}, Words{"--error", "0.3%"},
          Words{"--faces", "1000", "--refine", "volume"},
          Words{"--faces", "1000", "--refine", "importance"},
          Words{"--faces", "900", "--boundary", "keep"},
          Words{"--faces", "200", "--topology", "free"}})
      found[name + " " + joined(options)] = simplified(directory, path, options).hash;
  }
  for (const char* output : {"out.glb", "out.obj", "out.off", "out.stl"}) {
    found[std::string("whale_cranium.ply.zst --faces 1000 -o ") + output] =
        simplified(directory, inputs["whale_cranium.ply.zst"], {"--faces", "1000"}, {}, output)
            .hash;
  }
  const std::string map = directory.file("map.npy");
  for (const Words& options : {Words{"--grid", "60"}, Words{"--faces", "1000"},
                               Words{"--faces", "1000", "--detail", "6"}}) {
    for (const char* name : {"scan.stl", "whale_cranium.ply.zst"}) {
      const Words mapped = options + Words{"--map", map};
      const std::string mesh = simplified(directory, inputs[name], mapped).hash;
      CHECK(mesh == simplified(directory, inputs[name], options).hash);
      found[std::string(name) + " " + joined(options) + " --map"] = hash_of_file(map);
      ::unlink(map.c_str());
    }
  }
  const std::string attributed = directory.file("attributed.ply");
  write_attributed(attributed, generated(directory.path(), 20'000), usual_columns());
  for (const Words& options : {Words{"--faces", "1000"}, Words{"--faces", "500", "--detail", "6"},
                               Words{"--grid", "30"}}) {
    for (const char* output : {"out.ply", "out.glb"})
      found["attributed.ply " + joined(options) + " -o " + output] =
          simplified(directory, attributed, options, {}, output).hash;
  }
  return found;
}

}  // namespace

TEST_CASE("outputs have not changed", "[same_bytes]") {
  std::ifstream file(golden_path());
  std::map<std::string, std::string> golden;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    golden[line.substr(17)] = line.substr(0, 16);
  }
  const std::map<std::string, std::string> found = current();
  CHECK(golden.size() == found.size());
  for (const auto& [name, hash] : found) {
    INFO(name);
    CHECK(hash == golden[name]);
  }
}

TEST_CASE("renew the golden outputs", "[.]") {
  std::ofstream file(golden_path());
  file << "# FNV-1a of outputs of winnow simplify; read and renewed by same_bytes_golden.cpp, "
          "which says "
          "how.\n";
  for (const auto& [name, hash] : current()) file << hash << " " << name << "\n";
}

}  // namespace winnow::test
