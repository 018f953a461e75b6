#include "run/simplify_checkpoint.hpp"

#include <winnow/version.hpp>

#include "mesh/saved_mesh.hpp"

#include <utility>

namespace winnow {

namespace {

// In place of the output's identity where that has none, a pipe or a device.
constexpr const char* done = "straight";

constexpr const char* attribute_count = "clustered.attributes";
constexpr const char* rounding_relative = "clustered.rounding.relative";

std::string attribute_key(std::size_t number, const char* what) {
  return std::string(attribute_count) + "." + std::to_string(number) + "." + what;
}

}  // namespace

SimplifyCheckpoint SimplifyCheckpoint::begin(Job& job, const Checkpoint& settings,
                                             const SimplifyRequest& request) {
  SimplifyCheckpoint checkpoint;
  checkpoint.directory_ = CheckpointDirectory::begin(job, settings.directory);
  checkpoint.keep_ = settings.keep;
  Manifest& manifest = checkpoint.directory_->manifest();
  manifest.set("version", std::string(WINNOW_VERSION));
  put(manifest, request);
  put_inputs(manifest, request.inputs);
  return checkpoint;
}

SimplifyCheckpoint SimplifyCheckpoint::open(Job& job, const Checkpoint& settings) {
  SimplifyCheckpoint checkpoint;
  checkpoint.opened_ = true;
  checkpoint.directory_ = CheckpointDirectory::open(job, settings.directory);
  checkpoint.keep_ = settings.keep;
  const Manifest& manifest = checkpoint.directory_->manifest();
  if (manifest.text("version") != WINNOW_VERSION) {
    throw Error(ErrorKind::bad_input,
                "'" + settings.directory + "' is of winnow " + manifest.text("version") +
                    ", this is " + WINNOW_VERSION +
                    "; resume it with that one, or remove it and run `simplify` again");
  }
  return checkpoint;
}

void SimplifyCheckpoint::check_inputs() const {
  winnow::check_inputs(directory_->manifest(), has_mesh(), directory_->path());
}

SimplifyRequest SimplifyCheckpoint::request() const {
  return request_in(directory_->manifest());
}

void SimplifyCheckpoint::begun() {
  if (directory_ != nullptr) directory_->commit();
  begun_ = true;
}

bool SimplifyCheckpoint::has_mesh() const {
  return directory_ != nullptr && directory_->manifest().has("clustered.target");
}

Clustered SimplifyCheckpoint::load(Job& job, std::uint64_t memory) const {
  const Manifest& manifest = directory_->manifest();
  Clustered clustered;
  SimplifyReport& report = clustered.report;
  get_report(manifest, report);
  report.resumed.emplace().clustered = true;
  job.notes.insert(job.notes.begin(), report.notes.begin(), report.notes.end());
  job.progress.begin("go on", 0, "bytes");
  clustered.mesh = load_mesh(job, *directory_, memory);
  clustered.target = manifest.number("clustered.target");
  clustered.error = manifest.real("clustered.error");
  clustered.normals = manifest.number("clustered.normals") != 0;
  clustered.double_positions = manifest.number("clustered.double_positions") != 0;
  if (manifest.has(rounding_relative)) {
    clustered.mesh.rounding = {manifest.real(rounding_relative),
                               manifest.real("clustered.rounding.absolute")};
  }
  for (std::size_t i = 0; i < manifest.number(attribute_count); ++i) {
    Attribute& attribute = clustered.attributes.emplace_back();
    attribute.name = manifest.text(attribute_key(i, "name"));
    attribute.type = static_cast<NumberType>(manifest.number(attribute_key(i, "type")));
    attribute.kind = static_cast<AttributeKind>(manifest.number(attribute_key(i, "kind")));
    attribute.full = manifest.real(attribute_key(i, "full"));
    if (manifest.has(attribute_key(i, "no_data")))
      attribute.no_data = manifest.real(attribute_key(i, "no_data"));
  }
  return clustered;
}

void SimplifyCheckpoint::save(Job& job, Clustered& clustered) {
  if (directory_ == nullptr) return;
  job.progress.begin("keep", 0, "bytes");
  Manifest& manifest = directory_->manifest();
  clustered.report.notes = job.notes;
  put_report(manifest, clustered.report);
  manifest.set("clustered.target", clustered.target);
  manifest.set("clustered.error", clustered.error);
  manifest.set("clustered.normals", std::uint64_t{clustered.normals});
  manifest.set("clustered.double_positions", std::uint64_t{clustered.double_positions});
  if (clustered.mesh.rounding) {
    manifest.set(rounding_relative, clustered.mesh.rounding->relative);
    manifest.set("clustered.rounding.absolute", clustered.mesh.rounding->absolute);
  }
  manifest.set(attribute_count, std::uint64_t{clustered.attributes.size()});
  for (std::size_t i = 0; i < clustered.attributes.size(); ++i) {
    const Attribute& attribute = clustered.attributes[i];
    manifest.set(attribute_key(i, "name"), attribute.name);
    manifest.set(attribute_key(i, "type"), static_cast<std::uint64_t>(attribute.type));
    manifest.set(attribute_key(i, "kind"), static_cast<std::uint64_t>(attribute.kind));
    manifest.set(attribute_key(i, "full"), attribute.full);
    if (attribute.no_data) manifest.set(attribute_key(i, "no_data"), *attribute.no_data);
  }
  save_mesh(*directory_, clustered.mesh, 0, false);
  directory_->commit();
}

bool SimplifyCheckpoint::is_written(const std::string& output, SimplifyReport& report) const {
  if (directory_ == nullptr || !directory_->manifest().has("written")) return false;
  const Manifest& manifest = directory_->manifest();
  if (manifest.text("written") != done && !ByteSink::is(output, manifest.text("written")))
    return false;
  get_report(manifest, report);
  return true;
}

void SimplifyCheckpoint::settled(const std::string& identity, const SimplifyReport& report) {
  if (directory_ == nullptr) return;
  put_report(directory_->manifest(), report);
  directory_->manifest().set("written", identity);
  directory_->commit();
}

void SimplifyCheckpoint::finish(Job& job) {
  if (directory_ == nullptr || keep_) return;
  Manifest& manifest = directory_->manifest();
  if (manifest.text("written").empty()) {
    manifest.set("written", std::string(done));
    directory_->commit();
  }
  directory_->remove();
  if (job.context.notice)
    job.context.notice("the checkpoint in '" + directory_->path() +
                       "' is no longer needed and was removed");
}

void SimplifyCheckpoint::fail(const Error& error) {
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
