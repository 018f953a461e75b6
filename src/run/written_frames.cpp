#include "run/written_frames.hpp"

#include "io/byte_sink.hpp"
#include "run/run_request.hpp"

#include <cstdint>
#include <span>

namespace winnow {

namespace {

constexpr const char* frame_key = "frame";
constexpr const char* identity_key = "identity";

}  // namespace

WrittenFrames::WrittenFrames(const CheckpointDirectory* checkpoint) {
  if (checkpoint == nullptr) return;
  path_ = checkpoint->file("stage-output.written");
  journal_ = std::make_unique<Journal>(path_);
  for (std::vector<std::byte> record; journal_->next(record);) {
    const std::string text(reinterpret_cast<const char*>(record.data()), record.size());
    Manifest frame = Manifest::parse(text, path_);
    const std::uint64_t number = frame.number(frame_key);
    frames_.insert_or_assign(number, std::move(frame));
  }
}

bool WrittenFrames::has(std::size_t frame, const std::string& name) const {
  return frames_.contains(frame) && ByteSink::is(name, identity(frame));
}

std::size_t WrittenFrames::count(const std::vector<std::string>& names) const {
  std::size_t frames = 0;
  while (frames < names.size() && has(frames, names[frames])) ++frames;
  return frames;
}

std::string WrittenFrames::identity(std::size_t frame) const {
  return frames_.at(frame).text(identity_key);
}

void WrittenFrames::load_report(std::size_t frame, SequenceReport& report) const {
  get_report(frames_.at(frame), report);
}

void WrittenFrames::add(std::size_t frame, const std::string& identity,
                        const SequenceReport& report) {
  if (journal_ == nullptr) return;
  Manifest record;
  record.set(frame_key, std::uint64_t{frame});
  record.set(identity_key, identity);
  put_report(record, report);
  const std::string text = record.print();
  journal_->append({std::as_bytes(std::span(text))});
  journal_->sync();
}

}  // namespace winnow
