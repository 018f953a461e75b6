#include "read/ply/lists.hpp"

#include <winnow/error.hpp>

#include <algorithm>

namespace winnow {

void PlyLists::add(RawBatch& batch, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                   FaceStatus status) {
  batch.indices.insert(batch.indices.end(), {a, b, c});
  batch.status.push_back(status);
  ++batch.count;
}

void PlyLists::begin_record(RawBatch& batch) {
  values_.now_reading(element_.name.c_str(), records_);
  for (const PlyProperty& property : element_.properties) {
    if (&property == &list_) break;
    skip_property(values_, property);
  }
  const std::int64_t count = values_.integer(list_.count_type);
  left_ = count < 0 ? 0 : static_cast<std::uint64_t>(count);
  seen_ = 0;
  ++records_;
  if (left_ < 3 && !strips_) {
    values_.skip(list_.type, left_);
    left_ = 0;
    add(batch, 0, 0, 0, FaceStatus::degenerate);
  }
  if (left_ > 3 && !strips_) batch.fans.push_back({batch.count, left_ - 2});
  if (left_ == 0) end_record();
}

void PlyLists::end_record() {
  bool behind = false;
  for (const PlyProperty& property : element_.properties) {
    if (behind) skip_property(values_, property);
    behind |= &property == &list_;
  }
}

void PlyLists::next_index(RawBatch& batch) {
  const std::int64_t value = values_.integer(list_.type);
  --left_;
  if (strips_ && value == -1) {  // a new strip begins
    seen_ = 0;
    return;
  }
  // No vertex has the highest number, so it stands for every index that 32 bits do not hold.
  const auto index =
      static_cast<std::uint32_t>(value < 0 || value > UINT32_MAX ? UINT32_MAX : value);
  ++seen_;
  if (seen_ >= 3) {
    if (!strips_) {
      add(batch, first_, last_, index, FaceStatus::good);
    } else if (before_ != last_ && last_ != index && before_ != index) {
      // A repeated index only turns a strip around a corner; that is no face. Every second one is
      // mirrored.
      if (seen_ % 2 == 1) {
        add(batch, before_, last_, index, FaceStatus::good);
      } else {
        add(batch, last_, before_, index, FaceStatus::good);
      }
    }
  }
  if (seen_ == 1) first_ = index;
  before_ = last_;
  last_ = index;
}

void PlyLists::read(RawBatch& batch, std::uint64_t most, const RawBatch::Grow& grow,
                    std::uint64_t most_records) {
  const std::uint64_t until =
      most_records > element_.count - records_ ? element_.count : records_ + most_records;
  // The header of a list may promise more than there is, so its memory grows with what is read.
  std::uint64_t room = most;
  while (batch.count < most || (left_ > 0 && !strips_)) {
    if (batch.count == room) {
      room += std::clamp<std::uint64_t>(room / 4, 1, left_);
      try {
        grow(room);
      } catch (const Error& error) {
        // The budget to be named is that for all of it.
        if (error.kind() == ErrorKind::resources) grow(batch.count + left_);
        throw;
      }
      batch.indices.reserve(3 * room);
      batch.status.reserve(room);
    } else if (batch.count > most && batch.count % (1 << 16) == 0) {
      grow(room);
    }
    if (left_ > 0) {
      next_index(batch);
      if (left_ == 0) end_record();
    } else if (records_ < until) {
      begin_record(batch);
    } else {
      break;
    }
  }
}

}  // namespace winnow
