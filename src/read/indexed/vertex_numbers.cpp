#include "read/indexed/vertex_numbers.hpp"

#include "base/search.hpp"
#include "io/sorted_runs.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

namespace winnow {

struct VertexNumbers::Named {
  std::uint32_t number = 0, place = 0;

  static bool before(const Named& a, const Named& b) {
    return std::tie(a.number, a.place) < std::tie(b.number, b.place);
  }
  static bool combine(Named& /*a*/, const Named& /*b*/) { return false; }
};

VertexNumbers::VertexNumbers(Job& job, std::uint64_t memory_limit)
    : job_(job), memory_limit_(memory_limit), others_(std::make_unique<Spool>(job, memory_limit)) {}

void VertexNumbers::add(std::span<const std::uint32_t> numbers) {
  for (const std::uint32_t number : numbers) {
    const std::uint64_t place = count_++;
    if (place == plain_ && number == place + 1) {
      ++plain_;
      continue;
    }
    sorted_ = sorted_ && number > last_ && number > plain_;
    last_ = number;
    const Named named{number, static_cast<std::uint32_t>(place)};
    others_->append(std::as_bytes(std::span(&named, 1)));
  }
}

void VertexNumbers::finish() {
  others_->finish();
  if (!sorted_) sort();
}

void VertexNumbers::sort() {
  constexpr std::size_t at_once = std::size_t{1} << 16;
  SortedRuns<Named> runs(job_);
  std::vector<Named> part(at_once);
  const std::uint64_t total = others_->size() / sizeof(Named);
  for (std::uint64_t from = 0; from < total; from += at_once) {
    part.resize(std::min<std::uint64_t>(at_once, total - from));
    others_->read(from * sizeof(Named), std::as_writable_bytes(std::span(part)));
    std::sort(part.begin(), part.end(), Before<Named>());
    MemoryCursor<Named> sorted(part);
    runs.add(sorted);
    job_.progress.check_cancelled();
  }
  others_ = std::make_unique<Spool>(job_, memory_limit_);
  std::vector<std::unique_ptr<RecordCursor<Named>>> cursors;
  runs.add_cursors(cursors);
  MergedCursor<Named> merged(std::move(cursors));
  for (Named named; merged.next(named);) others_->append(std::as_bytes(std::span(&named, 1)));
  others_->finish();
}

void VertexNumbers::find(std::span<std::uint32_t> numbers) const {
  RecentBlocks others(*others_, sizeof(Named));
  for (std::uint32_t& number : numbers) number = place_of(number, others);
}

std::uint32_t VertexNumbers::place_of(std::uint32_t number, RecentBlocks& others) const {
  const std::uint64_t behind =
      first_not_before(0, others_->size() / sizeof(Named),
                       [&](std::uint64_t n) { return others.at<Named>(n).number <= number; });
  if (behind > 0) {
    const Named found = others.at<Named>(behind - 1);
    if (found.number == number) return found.place;
  }
  return number >= 1 && number <= plain_ ? number - 1 : UINT32_MAX;
}

}  // namespace winnow
