// Converting averages nothing: what vertices carry is what it was, to the bit.
#include "support/attributes.hpp"
#include "support/budget.hpp"
#include "support/not_finite.hpp"
#include "support/simplified.hpp"

#include <cmath>
#include <cstring>

namespace winnow::test {

namespace {

std::vector<Column> all_columns() {
  std::vector<Column> columns = usual_columns();
  columns.insert(columns.begin() + 2,
                 {"s", NumberType::float32, [](const Point& p) { return p[0]; }});
  columns.push_back({"nx", NumberType::float32, [](const Point& p) { return 3 * p[0]; }});
  columns.push_back({"ny", NumberType::float32, [](const Point& p) { return p[1]; }});
  columns.push_back({"nz", NumberType::float32, [](const Point&) { return 0; }});
  columns.push_back({"odd", NumberType::float64, [](const Point& p) {
                       return p[0] > 0.2 ? infinity : p[0] < -0.2 ? nan : 1e300;
                     }});
  return columns;
}

std::string converted(const Directory& directory, const std::string& input, const std::string& name,
                      const Words& options = {}, const Setup& setup = {}) {
  const std::string path = directory.file(name);
  winnow_ok(Words{"convert", input, "-o", path, "-q", "--force"} + options, setup);
  return path;
}

}  // namespace

TEST_CASE("attributes of a PLY are converted unchanged from every form to every form",
          "[same_bytes]") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  const AttributedMesh mesh = generated(directory.path(), 30'000);
  write_attributed(in, mesh, all_columns());
  const AttributedMesh want = read_attributed(in);
  for (const PlyForm form : {PlyForm::little_endian, PlyForm::big_endian, PlyForm::ascii}) {
    CAPTURE(static_cast<int>(form));
    write_attributed(in, mesh, all_columns(), form);
    const AttributedMesh out =
        read_attributed(converted(directory, in, "out.ply", {"--threads", "3"}));
    CHECK(out.properties == want.properties);
    CHECK(out.positions == want.positions);
    CHECK(out.faces == want.faces);
    for (const auto& [name, numbers] : want.columns) {
      INFO(name);
      const std::vector<double>& found = out.columns.at(name);
      REQUIRE(found.size() == numbers.size());
      // Also of what is no number.
      CHECK(std::memcmp(found.data(), numbers.data(), numbers.size() * sizeof(double)) == 0);
    }
    const std::string hash = hash_of_file(directory.file("out.ply"));
    CHECK(hash_of_file(converted(directory, "-", "out.ply", {"--threads", "1"}, {.in = in})) ==
          hash);
    const std::string text = converted(directory, in, "text.ply", {"--ascii"});
    CHECK(hash_of_file(converted(directory, text, "out.ply")) == hash);
  }
}

TEST_CASE("a conversion tells what it carries and what not") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  write_attributed(in, generated(directory.path(), 2'000), all_columns());
  const auto report = [&](const char* name) {
    return winnow_ok({"convert", in, "-o", directory.file(name), "--json"}).json();
  };
  CHECK(report("out.ply")["attributes"]["carried"].size() == 11);
  CHECK(report("out.ply.gz")["notes"].empty());
  const auto off = report("out.off");
  CHECK(off["attributes"]["carried"].size() == 6);
  CHECK(off["notes"] ==
        nlohmann::json{"not carried: the output's format holds no attributes but normals and "
                       "colours: s, quality, label, stamp, odd"});
  CHECK(bytes_of_file(directory.file("out.off")).starts_with("CNOFF\n"));
  CHECK(report("out.stl")["attributes"]["carried"].empty());
  CHECK(report("out.glb")["attributes"]["carried"].size() == 6);
}

TEST_CASE("converting attributes stays within the smallest budget and to the same bytes",
          "[budget]") {
  const Directory directory;
  const std::string in = directory.file("in.ply");
  write_attributed(in, generated(directory.path(), 400'000), all_columns());
  const Words command{"convert", in, "--threads", "2"};
  const std::string memory = smallest_memory_of(command);
  const std::string out = directory.file("out.ply");
  const Run run = run_winnow(command + Words{"-o", out, "--json", "--memory", memory});
  check_peak(run, memory);
  CHECK(run.json()["spilled_bytes"] > 8 * mebibyte);
  CHECK(run.json()["attributes"]["carried"].size() == 11);
  CHECK(hash_of_file(out) ==
        hash_of_file(converted(directory, in, "again.ply", {"--threads", "4"})));
}

}  // namespace winnow::test
