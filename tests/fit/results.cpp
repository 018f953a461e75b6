// Whole runs that fit: nearer, with the faces as they were, and exact where they were exact.
#include <winnow/error.hpp>
#include <winnow/simplify.hpp>

#include "support/checkpoints.hpp"
#include "support/simplified.hpp"

#include <cstring>
#include <filesystem>

namespace winnow::test {

namespace {

SimplifyOptions fitted_to(std::uint64_t faces, std::uint64_t passes = 1) {
  SimplifyOptions options;
  options.target = Target::faces(faces);
  options.fit = passes;
  return options;
}

SimplifyReport made(const std::string& input, const std::string& output,
                    const SimplifyOptions& options) {
  ::unlink(output.c_str());
  Context context;
  return simplify(context, input, output, options);
}

// From the end of the header of a binary PLY: positions, and what follows them.
struct Content {
  std::string vertices, faces;
};
Content content_of(const std::string& path, std::uint64_t vertices) {
  const std::string bytes = bytes_of_file(path);
  const std::size_t begin = bytes.find("end_header\n") + 11;
  return {bytes.substr(begin, 12 * vertices), bytes.substr(begin + 12 * vertices)};
}

}  // namespace

TEST_CASE("a fitted scan is nearer to the original, pass for pass", "[long]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  const std::string output = directory.file("out.ply");
  generate("scan", 100'000, input);
  for (const std::uint64_t faces : {10'000, 1'000}) {
    const SimplifyReport plain = made(input, output, fitted_to(faces, 0));
    CHECK(plain.fit.passes == 0);
    const Content before = content_of(output, plain.output.vertices);
    double last = 1e9;
    for (const std::uint64_t passes : {1, 3}) {
      const SimplifyReport report = made(input, output, fitted_to(faces, passes));
      INFO(faces << " faces, " << passes << " passes");
      CHECK(report.fit.passes == passes);
      CHECK(report.fit.samples > 11 * faces);
      CHECK(report.fit.rms_after < 0.93 * report.fit.rms_before);
      CHECK(report.fit.rms_after < last);
      CHECK(report.output.faces == plain.output.faces);
      CHECK(report.topology.closed);
      const Content after = content_of(output, report.output.vertices);
      CHECK(after.faces == before.faces);
      CHECK(after.vertices != before.vertices);
      last = report.fit.rms_after;
    }
  }
}

TEST_CASE("what is exact is the same to the byte when it is fitted") {
  const Directory directory;
  const std::string output = directory.file("out.ply");
  for (const auto& [surface, faces, wanted] :
       {std::tuple{"part", 40'000, 2'000}, std::tuple{"terrain", 40'000, 39'000}}) {
    const std::string input = directory.file(std::string(surface) + ".stl");
    generate(surface, static_cast<std::uint64_t>(faces), input);
    const auto count = static_cast<std::uint64_t>(wanted);
    const SimplifyReport plain = made(input, output, fitted_to(count, 0));
    const Content before = content_of(output, plain.output.vertices);
    const SimplifyReport report = made(input, output, fitted_to(count));
    const Content after = content_of(output, report.output.vertices);
    INFO(surface);
    CHECK(after.faces == before.faces);
    // Where a face of the result lies on the original, none of its corners moves.
    std::uint64_t same = 0;
    for (std::uint64_t v = 0; v < report.output.vertices; ++v)
      same += std::memcmp(&before.vertices[12 * v], &after.vertices[12 * v], 12) == 0 ? 1U : 0U;
    CHECK(2 * same > report.output.vertices);
    CHECK(same + report.fit.moved_vertices >= report.output.vertices);
  }
}

TEST_CASE("a boundary stays to the bit") {
  const Directory directory;
  const std::string input = directory.file("terrain.ply");
  const std::string output = directory.file("out.ply");
  generate("terrain", 60'000, input);
  const SimplifyReport plain = made(input, output, fitted_to(3'000, 0));
  CHECK(plain.topology.output.boundary > 50);
  const Content before = content_of(output, plain.output.vertices);
  const SimplifyReport report = made(input, output, fitted_to(3'000));
  CHECK(report.topology.output.boundary == plain.topology.output.boundary);
  const Content after = content_of(output, report.output.vertices);
  const std::uint64_t at_boundary = plain.topology.output.boundary;
  std::uint64_t same = 0;
  for (std::uint64_t v = 0; v < report.output.vertices; ++v)
    same += std::memcmp(&before.vertices[12 * v], &after.vertices[12 * v], 12) == 0 ? 1U : 0U;
  CHECK(same >= at_boundary);
  CHECK(report.fit.moved_vertices > report.output.vertices / 2);
}

TEST_CASE("each of several results is fitted, and none is begun from a fitted one") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 60'000, input);
  SimplifyOptions several = fitted_to(6'000);
  several.coarser = {Target::faces(1'000)};
  Context context;
  const SimplifyReport report = simplify(context, input, directory.file("{faces}.ply"), several);
  REQUIRE(report.levels.size() == 2);
  for (const LevelReport& level : report.levels) {
    CHECK(level.fit.samples > 5'000);
    CHECK(level.fit.rms_after < level.fit.rms_before);
  }
  several.fit = 0;
  const SimplifyReport plain =
      simplify(context, input, directory.file("plain-{faces}.ply"), several);
  for (const char* name : {"6000.ply", "1000.ply"}) {
    const std::uint64_t vertices = plain.levels[name[0] == '6' ? 0 : 1].output.vertices;
    CHECK(content_of(directory.file(name), vertices).faces ==
          content_of(directory.file(std::string("plain-") + name), vertices).faces);
  }
}

TEST_CASE("fitting goes with a count and the quadric cost alone") {
  Context context;
  for (const char* what : {"error", "grid", "volume"}) {
    SimplifyOptions options = fitted_to(100);
    if (what[0] == 'e') options.target = Target::error(0.1);
    if (what[0] == 'g') options.target = Target::grid(10);
    if (what[0] == 'v') options.refine = Refine::volume;
    const Error error = error_of([&] { simplify(context, "in.ply", "out.ply", options); });
    INFO(what);
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find("`fit` goes with") == 0);
  }
}

TEST_CASE("a run that is stopped while it fits goes on to the same bytes") {
  const Directory directory;
  const std::string input = directory.file("in.ply");
  const std::string output = directory.file("out.ply");
  generate("scan", 160'000, input);
  SimplifyOptions options = fitted_to(6'000, 2);
  options.detail = 4;  // clustered, so that samples are kept
  made(input, output, options);
  const std::string want = hash_of_file(output);
  for (const char* stage : {"sample", "refine", "fit", "write"}) {
    ::unlink(output.c_str());
    const Checkpoint checkpoint = stopped_at(directory, {input}, output, options, stage);
    // Where samples were taken the input is needed no more.
    const std::string away = directory.file("away.ply");
    const bool taken = std::string(stage) != "sample";
    if (taken) std::filesystem::rename(input, away);
    const SimplifyReport report = resumed(checkpoint);
    if (taken) std::filesystem::rename(away, input);
    INFO(stage);
    CHECK(report.fit.passes == 2);
    CHECK(hash_of_file(output) == want);
  }
}

TEST_CASE("the same fitted bytes with any threads budget and way in", "[same_bytes]") {
  const Directory directory;
  const std::string input = directory.file("scan.ply");
  generate("scan", 300'000, input);
  for (const Words& options : {Words{"--faces", "40001", "--fit", "2"},
                               Words{"--faces", "6001", "--detail", "4", "--fit", "1"}}) {
    INFO(joined(options));
    const Simplified one = simplified(directory, input, options + Words{"--threads", "1"});
    const std::string smallest = smallest_memory(input, options + Words{"--threads", "4"});
    const Simplified small =
        simplified(directory, input, options + Words{"--threads", "4", "--memory", smallest});
    const Simplified piped =
        simplified_by_pipe(directory, input, options + Words{"--threads", "2"});
    CHECK(small.report["spilled_bytes"] > 0);
    for (const Simplified* other : {&small, &piped}) {
      CHECK(other->hash == one.hash);
      CHECK(other->report["fit"] == one.report["fit"]);
    }
  }
}

}  // namespace winnow::test
