#include "stitch/saved_records.hpp"

#include "io/spool_records.hpp"

#include <string>
#include <type_traits>
#include <utility>

namespace winnow {

namespace {

static_assert(std::is_trivially_copyable_v<RecordedPart>);

constexpr const char* round_count = "record.rounds";
constexpr const char* words_part = ".record-words";
constexpr const char* gone_part = ".record-gone";
constexpr const char* parts_part = ".record-parts";

std::string name_of(std::uint64_t round) {
  return "round-" + std::to_string(round);
}

}  // namespace

void save_record(Job& job, CheckpointDirectory& checkpoint, std::uint64_t rounds,
                 const RecordedRound& last, const RecordState& state) {
  const std::string name = name_of(rounds);
  checkpoint.save(name + words_part, last.words());
  checkpoint.save(name + gone_part, last.gone());
  Spool parts(job, mebibyte);
  append_records<RecordedPart>(parts, last.parts());
  parts.finish();
  checkpoint.save(name + parts_part, parts);
  Manifest& manifest = checkpoint.manifest();
  manifest.set(round_count, rounds);
  manifest.set("record.collapses", state.collapses);
  manifest.set("record.idle", std::uint64_t{state.idle});
  manifest.set("record.done", std::uint64_t{state.done});
}

std::uint64_t saved_records(const CheckpointDirectory& checkpoint) {
  return checkpoint.manifest().has(round_count) ? checkpoint.manifest().number(round_count) : 0;
}

RecordState load_record_state(const CheckpointDirectory& checkpoint) {
  const Manifest& manifest = checkpoint.manifest();
  return {manifest.number("record.collapses"),
          static_cast<unsigned>(manifest.number("record.idle")),
          manifest.number("record.done") != 0};
}

RecordedRound load_record(const CheckpointDirectory& checkpoint, std::uint64_t round,
                          std::uint64_t memory) {
  const std::string name = name_of(round);
  const Spool parts = checkpoint.load(name + parts_part, mebibyte);
  return {checkpoint.load(name + words_part, memory - memory / 16),
          checkpoint.load(name + gone_part, memory / 16),
          read_records<RecordedPart>(parts, 0, record_count<RecordedPart>(parts))};
}

}  // namespace winnow
