// Several files carry what all of them have; a box does not change what its vertices carry.
#include "support/attributes.hpp"
#include "support/simplified.hpp"

#include <algorithm>

namespace winnow::test {

namespace {

// The same vertices and the faces from `begin` to `end`.
AttributedMesh part_of(const AttributedMesh& mesh, std::size_t begin, std::size_t end) {
  AttributedMesh part = mesh;
  part.faces.assign(mesh.faces.begin() + static_cast<std::ptrdiff_t>(begin),
                    mesh.faces.begin() + static_cast<std::ptrdiff_t>(end));
  return part;
}

// A mesh as one file, and as three whose columns come in other orders, are of other types, or are
// missing.
struct Parts {
  Directory directory;
  std::string whole = directory.file("whole.ply");
  Words files;

  explicit Parts(const std::vector<Column>& common) {
    const AttributedMesh mesh = generated(directory.path(), 20'000);
    write_attributed(whole, mesh, common);
    std::vector<Column> columns = common;
    columns.push_back({"other_type", NumberType::float32, [](const Point& p) { return p[0]; }});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string& file =
          files.emplace_back(directory.file("part" + std::to_string(i) + ".ply"));
      write_attributed(file,
                       part_of(mesh, mesh.faces.size() * i / 3, mesh.faces.size() * (i + 1) / 3),
                       columns, i == 1 ? PlyForm::ascii : PlyForm::little_endian);
      if (i == 0) {
        columns.back().type = NumberType::float64;
        columns.push_back({"not_in_all", NumberType::uint8, [](const Point&) { return 7; }});
        std::reverse(columns.begin(), columns.end());
      }
    }
    files[2] = zstd_file(files[2]);
  }

  Simplified joined_by(const Words& options) {
    const std::string path = directory.file("files.ply");
    const Run run = winnow_ok(Words{"simplify"} + files + Words{"-o", path, "--json"} + options);
    Simplified result{hash_of_file(path), run.json()};
    ::unlink(path.c_str());
    return result;
  }
};

}  // namespace

TEST_CASE("several files carry what all have and tell what only some have", "[same_bytes]") {
  Parts parts(usual_columns());
  for (const Words& options :
       {Words{"--cell", "0.03"}, Words{"--grid", "50"}, Words{"--faces", "3000"},
        Words{"--error", "1%", "--attributes", "stamp,colors"}}) {
    INFO(joined(options));
    const Simplified want = simplified(parts.directory, parts.whole, options);
    const Simplified all = parts.joined_by(options);
    CHECK(all.hash == want.hash);
    CHECK(all.report["attributes"]["carried"] == want.report["attributes"]["carried"]);
    CHECK(parts.joined_by(options + Words{"--threads", "1", "--memory", "70M"}).hash == want.hash);
    if (options.back() == "stamp,colors") continue;
    CHECK(all.report["attributes"]["dropped"] ==
          nlohmann::json{"not in every input, or not of one type: other_type, not_in_all"});
    CHECK(all.report["notes"].size() == 1);
  }
}

TEST_CASE("what not all files have cannot be asked for by name") {
  Parts parts({usual_columns()[0]});
  const Run run = run_winnow(Words{"simplify"} + parts.files +
                             Words{"-o", parts.directory.file("never.ply"), "--faces", "100",
                                   "--attributes", "other_type"});
  CHECK(run.code == 2);
  CHECK_THAT(run.err, Catch::Contains("'other_type' is not in every input, or not of one type"));
  CHECK_FALSE(exists(parts.directory.file("never.ply")));
}

TEST_CASE("a file without vertices keeps others from nothing") {
  const Parts parts(usual_columns());
  const std::string empty = parts.directory.file("empty.ply");
  write_attributed(empty, {}, {});
  const Words options{"--faces", "3000"};
  const std::string path = parts.directory.file("files.ply");
  winnow_ok(Words{"simplify", empty, parts.whole, "-o", path, "-q"} + options);
  CHECK(hash_of_file(path) == simplified(parts.directory, parts.whole, options).hash);
}

TEST_CASE("a box that holds all changes nothing of what is carried", "[same_bytes]") {
  const Parts parts(usual_columns());
  for (const Words& options : {Words{"--grid", "50"}, Words{"--faces", "3000"}}) {
    const Simplified want = simplified(parts.directory, parts.whole, options);
    CHECK(simplified(parts.directory, parts.whole, options + Words{"--crop", "-9,-9,-9,9,9,9"})
              .hash == want.hash);
  }
}

}  // namespace winnow::test
