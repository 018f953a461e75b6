// A GLB that meshoptimizer packed holds the same mesh as one that is plain, in fewer bytes.
#include <winnow/convert.hpp>

#include "support/budget.hpp"
#include "support/glb_file.hpp"
#include "support/job.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

using Corner = std::array<float, 6>;  // position and normal

constexpr std::size_t block_faces = 32'768;

// A face by what its corners are, the lowest first: packing may turn it round.
std::array<Corner, 3> face_at(const GlbFile& glb, std::size_t i) {
  std::array<Corner, 3> face{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = glb.faces[i][k];
    std::copy_n(glb.positions[vertex].begin(), 3, face[k].begin());
    if (!glb.normals.empty()) std::copy_n(glb.normals[vertex].begin(), 3, face[k].begin() + 3);
  }
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

void check_same_faces(const GlbFile& packed, const GlbFile& plain) {
  CHECK(packed.offset == plain.offset);
  REQUIRE(packed.faces.size() == plain.faces.size());
  // Within a block they come in another order.
  std::size_t different = 0;
  for (std::size_t first = 0; first < plain.faces.size(); first += block_faces) {
    const auto faces_of = [&](const GlbFile& glb) {
      std::vector<std::array<Corner, 3>> faces;
      for (std::size_t i = first; i < std::min(first + block_faces, plain.faces.size()); ++i)
        faces.push_back(face_at(glb, i));
      std::sort(faces.begin(), faces.end());
      return faces;
    };
    if (faces_of(packed) != faces_of(plain)) ++different;
  }
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("a packed GLB holds the faces of a plain one, block by block", "[long]") {
  const Directory directory;
  const std::string scan = directory.file("scan.ply");
  GenerateOptions away;
  away.offset = {431000, 5412000, 300};
  generate("scan", 150'000, scan, away);
  for (const Words& command :
       {Words{"convert", scan}, Words{"simplify", scan, "--ratio", "80%", "--normals"},
        Words{"simplify", scan, "--faces", "1000"}}) {
    INFO(joined(command));
    const std::string plain = directory.file("plain.glb");
    const std::string packed = directory.file("packed.glb");
    winnow_ok(command + Words{"-o", plain, "-q", "--force"});
    winnow_ok(command + Words{"-o", packed, "-q", "--force", "--compress", "meshopt"});
    const GlbFile right = glb_file(bytes_of_file(plain));
    const GlbFile found = glb_file(bytes_of_file(packed));
    check_same_faces(found, right);
    CHECK(found.json["extensionsRequired"] == nlohmann::json{"EXT_meshopt_compression"});
    CHECK(found.primitives == (right.faces.size() + block_faces - 1) / block_faces);
    // Vertices between primitives are in each of them.
    CHECK(found.positions.size() < right.positions.size() * 11 / 10);
    CHECK(size_of_file(packed) < size_of_file(plain) * 2 / 3);
  }
}

TEST_CASE("the same bytes of a packed GLB with any threads and memory", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 600'000, input);
  const Words command{"convert", input, "--compress", "meshopt", "-q", "--force"};
  std::string right;
  const std::string smallest = smallest_memory_of(command + Words{"--to", "glb", "--threads", "2"});
  for (const Words& how : {Words{"--threads", "1", "--memory", "4G"}, Words{"--threads", "4"},
                           Words{"--threads", "2", "--memory", smallest}}) {
    const std::string output = directory.file("out.glb");
    winnow_ok(command + how + Words{"-o", output});
    if (right.empty()) right = hash_of_file(output);
    CHECK(hash_of_file(output) == right);
  }
}

TEST_CASE("packing a GLB stays within the budget", "[budget]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 3'000'000, input);
  const Words command{"convert", input, "--compress", "meshopt", "--threads", "2"};
  const Run run =
      run_winnow(command + Words{"-o", directory.file("out.glb"), "--json", "--memory", "64M"});
  check_peak(run, "64M");
  CHECK(run.json()["spilled_bytes"] > 32 * mebibyte);
}

TEST_CASE("triangles without a common vertex are packed, too") {
  const Directory directory;
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 120000\nproperty float x\nproperty float y\n"
      "property float z\nelement face 40000\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 40'000; ++i) {
    const std::string x = std::to_string(i);
    ply += x + " 0 0\n" + x + " 1 0\n" + x + " 0 1\n";
  }
  for (int i = 0; i < 120'000; i += 3)
    ply +=
        "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  write_file(directory.file("in.ply"), ply);
  Context context;
  context.scratch = directory.path();
  ConvertOptions options;
  convert(context, directory.file("in.ply"), directory.file("plain.glb"), options);
  options.encoding.compress = Compression::meshopt;
  convert(context, directory.file("in.ply"), directory.file("packed.glb"), options);
  check_same_faces(glb_file(bytes_of_file(directory.file("packed.glb"))),
                   glb_file(bytes_of_file(directory.file("plain.glb"))));
}

}  // namespace winnow::test
