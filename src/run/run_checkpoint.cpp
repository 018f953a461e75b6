#include "run/run_checkpoint.hpp"

#include <winnow/version.hpp>

#include "base/memory_shares.hpp"
#include "mesh/saved_mesh.hpp"
#include "run/mesh_facts.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>

namespace winnow {

namespace {

// In place of the output's identity where that has none, a pipe or a device.
constexpr const char* done = "straight";

constexpr const char* input_map = "stage-input.map";  // what Clustered::map is kept as

constexpr const char* samples_file = "stage-0.samples";
constexpr const char* samples_area = "clustered.samples.area";
constexpr const char* rounding_relative = "clustered.rounding.relative";

std::string written_key(std::size_t number) {
  return "written." + std::to_string(number);
}

std::string written_map_key(std::size_t number) {
  return "written.map." + std::to_string(number);
}

}  // namespace

RunCheckpoint RunCheckpoint::begin(Job& job, const Checkpoint& settings,
                                   const RunRequest& request) {
  RunCheckpoint checkpoint;
  checkpoint.directory_ = CheckpointDirectory::begin(job, settings.directory);
  checkpoint.keep_ = settings.keep;
  Manifest& manifest = checkpoint.directory_->manifest();
  manifest.set("version", std::string(WINNOW_VERSION));
  put(manifest, request);
  put_inputs(manifest, request.inputs);
  return checkpoint;
}

RunCheckpoint RunCheckpoint::open(Job& job, const Checkpoint& settings) {
  RunCheckpoint checkpoint;
  checkpoint.opened_ = true;
  checkpoint.directory_ = CheckpointDirectory::open(job, settings.directory);
  checkpoint.keep_ = settings.keep;
  const Manifest& manifest = checkpoint.directory_->manifest();
  if (manifest.text("version") != WINNOW_VERSION) {
    throw Error(ErrorKind::bad_input, "'" + settings.directory + "' is of winnow " +
                                          manifest.text("version") + ", this is " + WINNOW_VERSION +
                                          "; resume it with that one, or remove it and run `" +
                                          command_of(call_in(manifest)) + "` again");
  }
  return checkpoint;
}

void RunCheckpoint::check_inputs() const {
  winnow::check_inputs(directory_->manifest(), has_mesh(), directory_->path());
}

RunRequest RunCheckpoint::request(ResumableCall call) const {
  const ResumableCall own = call_in(directory_->manifest());
  if (own == call) return request_in(directory_->manifest());
  const std::string with =
      own == ResumableCall::simplify ? "resume()" : std::string("resume_") + command_of(own) + "()";
  throw Error(ErrorKind::usage, "'" + directory_->path() + "' is of a run of `" + command_of(own) +
                                    "`; go on with it by " + with);
}

ResumableCall call_of(const Checkpoint& settings) {
  try {
    const std::string name = settings.directory + "/manifest";
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(name, ignored)) return ResumableCall::simplify;
    std::ifstream in(name, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return call_in(Manifest::parse(text, name));
  } catch (const Error&) {
    return ResumableCall::simplify;
  }
}

void RunCheckpoint::begun() {
  if (directory_ != nullptr) directory_->commit();
  begun_ = true;
}

bool RunCheckpoint::has_mesh() const {
  return directory_ != nullptr && holds_facts(directory_->manifest());
}

Clustered RunCheckpoint::load(Job& job, std::uint64_t memory) const {
  const Manifest& manifest = directory_->manifest();
  Clustered clustered;
  SimplifyReport& report = clustered.report;
  get_report(manifest, report);
  report.resumed.emplace().clustered = true;
  job.notes.insert(job.notes.begin(), report.notes.begin(), report.notes.end());
  job.progress.begin("go on", 0, "bytes");
  if (directory_->has(input_map)) {
    const std::uint64_t held = share::left::map(memory);
    clustered.map = std::make_unique<Spool>(directory_->load(input_map, held));
    memory -= held;
  }
  clustered.mesh = load_mesh(job, *directory_, memory);
  MeshFacts facts = facts_in(manifest);
  clustered.goals = std::move(facts.goals);
  clustered.attributes = std::move(facts.attributes);
  clustered.normals = facts.normals;
  clustered.double_positions = facts.double_positions;
  if (manifest.has(rounding_relative)) {
    clustered.mesh.rounding = {manifest.real(rounding_relative),
                               manifest.real("clustered.rounding.absolute")};
  }
  if (directory_->has(samples_file)) {
    clustered.samples.points = std::make_unique<Spool>(
        directory_->load(samples_file, share::left::samples(job.budget.left())));
  }
  if (manifest.has(samples_area)) {
    clustered.samples.area = manifest.real(samples_area);
    clustered.samples.single = manifest.number("clustered.samples.single") != 0;
  }
  return clustered;
}

void RunCheckpoint::save(Job& job, Clustered& clustered) {
  if (directory_ == nullptr) return;
  job.progress.begin("keep", 0, "bytes");
  Manifest& manifest = directory_->manifest();
  clustered.report.notes = job.notes;
  put_report(manifest, clustered.report);
  put(manifest, MeshFacts{clustered.goals, clustered.attributes, clustered.normals,
                          clustered.double_positions});
  if (clustered.mesh.rounding) {
    manifest.set(rounding_relative, clustered.mesh.rounding->relative);
    manifest.set("clustered.rounding.absolute", clustered.mesh.rounding->absolute);
  }
  if (clustered.map != nullptr) directory_->save(input_map, *clustered.map);
  if (clustered.samples.points != nullptr)
    directory_->save(samples_file, *clustered.samples.points);
  if (clustered.samples.area > 0) {
    manifest.set(samples_area, clustered.samples.area);
    manifest.set("clustered.samples.single", std::uint64_t{clustered.samples.single});
  }
  save_mesh(*directory_, clustered.mesh, 0, false);
  directory_->commit();
}

bool RunCheckpoint::is_written(std::size_t number, const std::string& output) const {
  if (directory_ == nullptr || !directory_->manifest().has(written_key(number))) return false;
  const std::string identity = directory_->manifest().text(written_key(number));
  return identity == done || ByteSink::is(output, identity);
}

bool RunCheckpoint::are_written(const std::vector<std::string>& outputs) const {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!is_written(i, outputs[i])) return false;
  }
  return true;
}

bool RunCheckpoint::holds_map(std::size_t number, const std::string& path) const {
  const std::string key = written_map_key(number);
  return opened_ && directory_->manifest().has(key) &&
         ByteSink::is(path, directory_->manifest().text(key));
}

void RunCheckpoint::settle(const std::vector<std::string>& identities) {
  for (std::size_t i = 0; i < identities.size(); ++i)
    directory_->manifest().set(written_key(i), identities[i]);
  directory_->commit();
}

void RunCheckpoint::settled(const Outputs& outputs, const SimplifyReport& report) {
  if (directory_ == nullptr) return;
  for (std::size_t i = 0; i < outputs.maps.size(); ++i)
    directory_->manifest().set(written_map_key(i), outputs.maps[i]->identity());
  std::vector<std::string> identities;
  for (const auto& mesh : outputs.meshes) identities.push_back(mesh->identity());
  settled(identities, report);
}

void RunCheckpoint::finish(Job& job) {
  if (directory_ == nullptr || keep_) return;
  Manifest& manifest = directory_->manifest();
  bool straight = false;
  for (std::size_t i = 0; manifest.has(written_key(i)); ++i) {
    if (!manifest.text(written_key(i)).empty()) continue;
    manifest.set(written_key(i), std::string(done));
    straight = true;
  }
  if (straight) directory_->commit();
  directory_->remove();
  if (job.context.notice)
    job.context.notice("the checkpoint in '" + directory_->path() +
                       "' is no longer needed and was removed");
}

void RunCheckpoint::fail(const Error& error) {
  if (directory_ == nullptr) throw Error(error);
  // A pipe that was not read to its end cannot be read again.
  const bool can_go_on = has_mesh() || (begun_ && inputs_are_files(directory_->manifest()));
  const ErrorKind kind = error.kind();
  if (can_go_on &&
      (kind == ErrorKind::resources || kind == ErrorKind::cancelled || kind == ErrorKind::usage))
    throw Error(kind,
                std::string(error.what()) + "; go on by `resume` '" + directory_->path() + "'");
  // One that another run made is for its owner to remove.
  if (!opened_) directory_->remove();
  throw Error(error);
}

}  // namespace winnow
