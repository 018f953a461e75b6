#include "run/sequence_checkpoint.hpp"

#include "mesh/saved_mesh.hpp"
#include "run/mesh_facts.hpp"

#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace winnow {

namespace {

constexpr const char* frame_count = "frames.count";
constexpr const char* clips_file = "stage-input.clips";

template <typename Record, typename Records>
void put_all(Spool& into, const Records& records) {
  const std::uint64_t count = records.size();
  into.append(std::as_bytes(std::span(&count, 1)));
  into.append(std::as_bytes(std::span<const Record>(records)));
}

// Takes what put_all() put from the front of `bytes`; false where less is there.
template <typename Record, typename Records>
bool take_all(std::span<const std::byte>& bytes, Records& records) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes = bytes.subspan(sizeof count);
  if (count > bytes.size() / sizeof(Record)) return false;
  records.resize(count);
  if (count > 0) std::memcpy(records.data(), bytes.data(), count * sizeof(Record));
  bytes = bytes.subspan(count * sizeof(Record));
  return true;
}

Spool stored(Job& job, const std::vector<MorphClip>& clips) {
  Spool spool(job, job.budget.left() / 4);
  for (const MorphClip& clip : clips) {
    spool.append(std::as_bytes(std::span(&clip.between, 1)));
    put_all<char>(spool, clip.name);
    put_all<float>(spool, clip.times);
    put_all<std::uint32_t>(spool, clip.places);
    put_all<float>(spool, clip.weights);
  }
  spool.finish();
  return spool;
}

}  // namespace

void save(Job& job, RunCheckpoint& checkpoint, ReadSequence& read,
          const std::vector<MorphClip>& clips) {
  CheckpointDirectory* directory = checkpoint.directory();
  if (directory == nullptr) return;
  job.progress.begin("keep", 0, "bytes");
  Manifest& manifest = directory->manifest();
  const SequenceMesh& sequence = read.sequence;
  read.report.notes = job.notes;
  put_report(manifest, read.report);
  put(manifest,
      MeshFacts{
          {{read.faces, 0}}, sequence.attributes, sequence.normals, sequence.double_positions});
  manifest.set(frame_count, std::uint64_t{sequence.frames});
  sequence.original.save(job, *directory);
  directory->save(clips_file, stored(job, clips));
  save_mesh(*directory, sequence.mesh, 0, false);
  directory->commit();
}

ReadSequence load_sequence(Job& job, const RunCheckpoint& checkpoint, std::uint64_t frames,
                           std::uint64_t mesh) {
  const CheckpointDirectory& directory = *checkpoint.directory();
  ReadSequence read;
  checkpoint.load_report(read.report);
  read.report.resumed.emplace().clustered = true;
  job.notes.insert(job.notes.begin(), read.report.notes.begin(), read.report.notes.end());
  job.progress.begin("go on", 0, "bytes");
  MeshFacts facts = facts_in(directory.manifest());
  if (facts.goals.empty())
    damaged_checkpoint(directory.manifest_path(), "it has no count of faces");
  read.faces = facts.goals.front().faces;
  SequenceMesh& sequence = read.sequence;
  sequence.attributes = std::move(facts.attributes);
  sequence.normals = facts.normals;
  sequence.double_positions = facts.double_positions;
  sequence.frames = frames_in(directory);
  sequence.mesh = load_mesh(job, directory, mesh);
  sequence.original = OriginalFrames::load(job, directory, frames);
  return read;
}

std::size_t frames_in(const CheckpointDirectory& directory) {
  return directory.manifest().number(frame_count);
}

std::vector<MorphClip> load_clips(Job& job, const CheckpointDirectory& directory) {
  const Spool spool = directory.load(clips_file, job.budget.left() / 4);
  std::vector<std::byte> all(spool.size());
  spool.read(0, all);
  std::vector<MorphClip> clips;
  for (std::span<const std::byte> bytes(all); !bytes.empty();) {
    MorphClip& clip = clips.emplace_back();
    clip.between = static_cast<MorphClip::Between>(bytes.front());
    bytes = bytes.subspan(1);
    if (!take_all<char>(bytes, clip.name) || !take_all<float>(bytes, clip.times) ||
        !take_all<std::uint32_t>(bytes, clip.places) || !take_all<float>(bytes, clip.weights))
      damaged_checkpoint(directory.file(clips_file), "it ends too early");
  }
  return clips;
}

}  // namespace winnow
