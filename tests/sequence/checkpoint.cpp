// A sequence that was stopped at any stage goes on from its checkpoint, and ends with the same
// bytes.
#include <winnow/checkpoint.hpp>
#include <winnow/error.hpp>

#include "io/manifest.hpp"
#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace winnow::test {

namespace {

constexpr std::size_t frames = 5;

// Each frame has colours of its own.
std::vector<std::string> write_colored_frames(const Directory& directory, std::size_t n) {
  const std::vector<std::string> names = write_frames(directory, {n}, frames);
  for (std::size_t t = 0; t < frames; ++t) {
    std::istringstream lines(bytes_of_file(names[t]));
    std::string text;
    for (std::string line; std::getline(lines, line);)
      text += line + (line.starts_with("v ") ? " 0.5 0.25 0." + std::to_string(t) : "") + "\n";
    write_file(names[t], text);
  }
  return names;
}

// A sequence to simplify, the files that it becomes, and a place for its checkpoint.
struct Stopped {
  explicit Stopped(const std::string& ending, double per_frame = 0)
      : inputs(write_colored_frames(directory, 16)),
        one(ending == "glb"),
        output(directory.file(one ? "all.glb" : "s-{frame}." + ending)) {
    options.target = Target::ratio(0.2);
    options.per_frame = per_frame;
    for (std::size_t t = 0; t < (one ? 1 : frames); ++t)
      outputs.push_back(one ? output
                            : directory.file("s-" + std::to_string(t).append(".") + ending));
  }

  [[nodiscard]] std::string hashes() const {
    std::string all;
    for (const std::string& name : outputs) all += hash_of_file(name);
    return all;
  }
  void remove_outputs() const {
    for (const std::string& name : outputs) std::filesystem::remove(name);
  }
  std::string undisturbed() {
    Context context;
    context.scratch = directory.path();
    report = simplify_sequence(context, inputs, output, options);
    const std::string all = hashes();
    remove_outputs();
    return all;
  }

  // Stops where `stage` begins for the `time`th time.
  void stop(const std::string& stage, int time = 1) {
    Context context;
    context.threads = 2;
    context.progress = [&](const Progress& progress) {
      if (progress.done == 0 && progress.stage == stage && --time == 0) context.cancel();
    };
    const Error error =
        error_of([&] { simplify_sequence(context, inputs, output, options, checkpoint); });
    INFO(error.what());
    REQUIRE(error.kind() == ErrorKind::cancelled);
    REQUIRE(std::string(error.what()).find("go on by `resume` '" + checkpoint.directory + "'") !=
            std::string::npos);
    for (const std::string& name : outputs) REQUIRE_FALSE(exists(name));
  }
  [[nodiscard]] SequenceReport go_on() const {
    Context context;
    context.threads = 1;
    return resume_sequence(context, checkpoint);
  }
  // The run cannot be resumed, for this reason.
  void check_refused(const std::vector<std::string>& parts) const {
    const Error error = error_of([&] { (void)go_on(); });
    const std::string message = error.what();
    INFO(message);
    CHECK(error.kind() == ErrorKind::bad_input);
    for (const std::string& part : parts) CHECK(message.find(part) != std::string::npos);
    for (const std::string& name : outputs) CHECK_FALSE(exists(name));
  }

  Directory directory;
  std::vector<std::string> inputs, outputs;
  bool one;
  std::string output;
  SequenceOptions options;
  Checkpoint checkpoint{directory.file("kept")};
  SequenceReport report;
};

void flip(const std::string& path, std::size_t byte) {
  std::string bytes = bytes_of_file(path);
  bytes.at(byte) = static_cast<char>(bytes.at(byte) ^ 4);
  write_file(path, bytes);
}

}  // namespace

TEST_CASE("a sequence that was stopped in any stage ends with the same bytes", "[faults]") {
  const struct {
    const char* ending;
    double per_frame;
  } cases[] = {{"ply", 0}, {"obj.gz", 0.3}, {"glb", 0}};
  for (const auto& [ending, per_frame] : cases) {
    Stopped run(ending, per_frame);
    const std::string want = run.undisturbed();
    const struct {
      const char* stage;
      int time;
      bool read;
      std::uint64_t rounds;
    } places[] = {{"read frames", 1, false, 0}, {"order vertices", 1, false, 0},
                  {"keep", 1, false, 0},        {"refine", 1, true, 0},
                  {"keep", 2, true, 0},         {"unfold", 1, true, 1},
                  {"unfold", 4, true, 1},       {"write", 1, true, 1}};
    for (const auto& place : places) {
      CAPTURE(ending, place.stage, place.time);
      run.stop(place.stage, place.time);
      CHECK(call_of(run.checkpoint) == ResumableCall::sequence);
      // Where the frames were read they are needed no more.
      const std::string away = run.directory.file("away.obj");
      if (place.read) std::filesystem::rename(run.inputs[1], away);
      const SequenceReport report = run.go_on();
      if (place.read) std::filesystem::rename(away, run.inputs[1]);
      CHECK(run.hashes() == want);
      REQUIRE(report.resumed);
      CHECK(report.resumed->clustered == place.read);
      CHECK(report.resumed->rounds == place.rounds);
      CHECK(report.input.names == run.inputs);
      CHECK(report.input.bytes == run.report.input.bytes);
      CHECK(report.output.names == run.outputs);
      CHECK(report.output.bytes == run.report.output.bytes);
      CHECK(report.output.faces == run.report.output.faces);
      CHECK(report.collapses == run.report.collapses);
      CHECK(report.area.input == run.report.area.input);
      CHECK(report.area.output == run.report.area.output);
      CHECK(report.notes == run.report.notes);
      CHECK(std::filesystem::is_empty(run.checkpoint.directory));
      run.remove_outputs();
    }
  }
}

TEST_CASE("the animations of a glTF that was read come from the checkpoint", "[faults]") {
  Stopped run("glb");
  run.undisturbed();
  TestJob job;
  const std::string clip = run.directory.file("clip.glb");
  run.options.target = Target::ratio(1);
  (void)simplify_sequence(job.context, run.inputs, clip, run.options);
  std::string bytes = bytes_of_file(clip);
  const std::string plain = "\"LINEAR\"";
  REQUIRE(bytes.find(plain) != std::string::npos);
  bytes.replace(bytes.find(plain), plain.size(), "\"STEP\"  ");
  write_file(clip, bytes);
  run.inputs = {clip};
  run.options.target = Target::ratio(0.2);
  const std::string want = run.undisturbed();
  run.stop("refine");
  std::filesystem::remove(clip);
  CHECK(run.go_on().input.bytes == bytes.size());
  CHECK(bytes_of_file(run.output).find("\"STEP\"") != std::string::npos);
  CHECK(run.hashes() == want);
}

TEST_CASE("frames whose names were sorted keep their order and their numbers", "[faults]") {
  Stopped run("ply");
  const std::string want = run.undisturbed();
  std::swap(run.inputs[0], run.inputs[3]);
  run.stop("read frames");
  CHECK(run.go_on().resumed);
  CHECK(run.hashes() == want);
}

TEST_CASE("a sequence whose checkpoint is kept is told to be done, or written again", "[faults]") {
  for (const char* ending : {"ply", "glb"}) {
    Stopped run(ending);
    const std::string want = run.undisturbed();
    run.checkpoint.keep = true;
    Context context;
    (void)simplify_sequence(context, run.inputs, run.output, run.options, run.checkpoint);
    const SequenceReport done = run.go_on();
    REQUIRE(done.resumed);
    CHECK(done.resumed->written);
    CHECK(done.output.bytes == run.report.output.bytes);
    CHECK(done.output.names == run.outputs);
    std::filesystem::remove(run.outputs.back());
    run.checkpoint.keep = false;
    CHECK_FALSE(run.go_on().resumed->written);
    CHECK(run.hashes() == want);
    CHECK(std::filesystem::is_empty(run.checkpoint.directory));
  }
}

TEST_CASE("a damaged checkpoint of a sequence is refused and its file named", "[faults]") {
  Stopped run("glb");
  run.stop("unfold");
  for (const char* name : {"manifest", "stage-input.frames", "stage-input.used", "stage-0.vertices",
                           "stage-1.state", "stage-1.attributes"}) {
    const std::string path = run.checkpoint.directory + "/" + name;
    const std::string bytes = bytes_of_file(path);
    flip(path, bytes.size() / 2);
    run.check_refused({"'" + path + "' is damaged", "remove the checkpoint's directory"});
    write_file(path, bytes.substr(0, bytes.size() - 1));
    run.check_refused({"'" + path + "' is damaged"});
    ::unlink(path.c_str());
    if (std::string(name) != "manifest")
      run.check_refused({"'" + path + "' is damaged: it is missing"});
    write_file(path, bytes);
  }
  CHECK(run.go_on().resumed);
}

TEST_CASE("a frame that has changed is refused, and one that is gone before all were read",
          "[faults]") {
  for (const char* stage : {"read frames", "refine"}) {
    Stopped run("ply");
    run.stop(stage);
    const std::string frame = run.inputs[2];
    flip(frame, bytes_of_file(frame).size() - 4);
    run.check_refused(
        {"'" + frame + "' has changed", run.checkpoint.directory, "run `sequence` again"});
    std::filesystem::remove(frame);
    if (std::string(stage) == "refine") {
      CHECK(run.go_on().resumed->clustered);
    } else {
      run.check_refused({"'" + frame + "'", "is not there", "run `sequence` again"});
    }
  }
}

TEST_CASE("a checkpoint is gone on with by the call that it is of", "[faults]") {
  Stopped run("ply");
  run.stop("refine");
  Context context;
  const auto check = [](const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(std::string(error.what()).find("go on with it by resume_sequence()") !=
          std::string::npos);
  };
  check(error_of([&] { resume(context, run.checkpoint); }));
  check(error_of([&] { resume_progressive(context, run.checkpoint); }));
  SimplifyOptions options;
  options.target = Target::ratio(0.5);
  const Checkpoint other{run.directory.file("other"), true};
  (void)simplify(context, std::vector{run.inputs[0]}, run.directory.file("m.ply"), options, other);
  const Error error = error_of([&] { resume_sequence(context, other); });
  CHECK(error.kind() == ErrorKind::usage);
  CHECK(std::string(error.what()).find("by resume()") != std::string::npos);
  CHECK(run.go_on().resumed);
}

}  // namespace winnow::test
