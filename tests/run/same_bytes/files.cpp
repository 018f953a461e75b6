// Several files are one model: the bytes are those of one file with the same faces in the same
// order.
#include "support/simplified.hpp"
#include "support/stl_file.hpp"

#include <fstream>

namespace winnow::test {

namespace {

// A binary STL cut into three, of which one is packed and one is text.
Words parts_of(const Directory& directory, const std::string& stl) {
  const std::string whole = bytes_of_file(stl);
  const std::size_t faces = (whole.size() - 84) / 50;
  Words names;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t begin = faces * i / 3;
    const std::size_t end = faces * (i + 1) / 3;
    std::string part = whole.substr(0, 80);
    const auto count = static_cast<std::uint32_t>(end - begin);
    part.append(reinterpret_cast<const char*>(&count), sizeof count);
    part += whole.substr(84 + 50 * begin, 50 * (end - begin));
    const std::string name = directory.file("part" + std::to_string(i) + ".stl");
    write_file(name, part);
    names.push_back(i == 0   ? name
                    : i == 1 ? gzip_file(name)
                             : ascii_file(name, directory.file("part-text.stl")));
  }
  return names;
}

// As simplified() of several inputs.
Simplified simplified_files(const Directory& directory, const Words& inputs, const Words& options) {
  const std::string path = directory.file("files.ply");
  const Run run = winnow_ok(Words{"simplify"} + inputs + Words{"-o", path, "--json"} + options);
  Simplified result{hash_of_file(path), run.json()};
  ::unlink(path.c_str());
  return result;
}

}  // namespace

TEST_CASE("the same bytes from one file and from several that hold its faces", "[same_bytes]") {
  const Directory directory;
  const std::string whole = directory.file("whole.stl");
  generate("scan", 30'000, whole);
  const Words parts = parts_of(directory, whole);
  for (const Words& options :
       {Words{"--cell", "0.03"}, Words{"--grid", "50"}, Words{"--faces", "3000"},
        Words{"--faces", "3000", "--refine", "none"}, Words{"--ratio", "20%", "--refine", "none"},
        Words{"--error", "1%"}, Words{"--cell", "0.03", "--crop", "-1,-1,-1,1,0.25,1"}}) {
    INFO(joined(options));
    const Simplified want = simplified(directory, whole, options);
    const Simplified all = simplified_files(directory, parts, options);
    CHECK(all.hash == want.hash);
    CHECK(all.report["input"]["faces"] == want.report["input"]["faces"]);
    CHECK(simplified_files(directory, parts, options + Words{"--threads", "1", "--memory", "40M"})
              .hash == want.hash);
  }
}

TEST_CASE("the same bytes from a cropped model and from its faces inside of the box",
          "[same_bytes]") {
  const Directory directory;
  const std::string whole = directory.file("whole.stl");
  generate("scan", 20'000, whole);
  const std::string bytes = bytes_of_file(whole);
  std::string inside = bytes.substr(0, 84);
  std::uint32_t count = 0;
  for (std::size_t at = 84; at < bytes.size(); at += 50) {
    std::array<float, 12> face{};
    std::memcpy(face.data(), bytes.data() + at, sizeof face);
    bool keep = true;
    for (std::size_t corner = 1; corner < 4; ++corner)
      keep = keep && face[3 * corner] >= 0.125F && face[3 * corner] <= 0.5F;
    if (!keep) continue;
    inside += bytes.substr(at, 50);
    ++count;
  }
  std::memcpy(inside.data() + 80, &count, sizeof count);
  REQUIRE(count > 1000);
  write_file(directory.file("inside.stl"), inside);
  const Words crop{"--crop", "0.125,-10,-10,0.5,10,10"};
  // What hangs on the faces alone: not on a box of vertices, nor on where the first one is.
  for (const Words& options :
       {Words{"--faces", "500", "--detail", "full"}, Words{"--ratio", "20%", "--detail", "full"}}) {
    INFO(joined(options));
    const Simplified want = simplified(directory, directory.file("inside.stl"), options);
    const Simplified cropped = simplified(directory, whole, options + crop);
    CHECK(cropped.report["output"]["faces"] == want.report["output"]["faces"]);
    CHECK(cropped.report["input"]["cropped_faces"] ==
          want.report["input"]["cropped_faces"].get<std::uint64_t>() + (bytes.size() - 84) / 50 -
              count);
  }
  const Simplified file = simplified(directory, whole, Words{"--faces", "500"} + crop);
  CHECK(simplified(directory, "-", Words{"--faces", "500"} + crop, {.in = whole}).hash ==
        file.hash);
  CHECK(simplified(directory, whole,
                   Words{"--faces", "500", "--memory", "40M", "--threads", "1"} + crop)
            .hash == file.hash);
}

}  // namespace winnow::test
