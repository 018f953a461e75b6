// The material of a GLB: no metal, and seen from both sides where the mesh is open.
#include "support/glb_file.hpp"
#include "support/simplified.hpp"

#include <catch2/catch.hpp>

namespace winnow::test {

TEST_CASE("the material of a GLB is double-sided if the mesh is open") {
  const Directory directory;
  generate("scan", 4000, directory.file("closed.ply"));
  generate("terrain", 4000, directory.file("open.ply"));
  const std::string output = directory.file("out.glb");
  for (const std::string name : {"closed", "open"}) {
    for (const Words& command : {Words{"convert"}, Words{"simplify", "--faces", "1000"},
                                 Words{"simplify", "--grid", "20"}}) {
      for (const Words& packing : {Words{}, Words{"--compress", "meshopt"}}) {
        INFO(name << " " << joined(command + packing));
        const Run run =
            winnow_ok(command + packing +
                      Words{directory.file(name + ".ply"), "-o", output, "--json", "--force"});
        const nlohmann::json json = glb_file(bytes_of_file(output)).json;
        REQUIRE(json["materials"].size() == 1);
        // Coarse clustering may open a closed mesh.
        const bool open = command[0] == "convert" ? name == "open"
                                                  : !run.json()["topology"]["closed"].get<bool>();
        CHECK(json["materials"][0].value("doubleSided", false) == open);
        // It says nothing that another output would not, so no note tells of it.
        const Run back =
            winnow_ok({"convert", output, "-o", directory.file("back.ply"), "--force", "--json"});
        CHECK(back.json()["notes"].empty());
      }
    }
  }
}

}  // namespace winnow::test
