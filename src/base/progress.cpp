#include "base/progress.hpp"

#include <winnow/error.hpp>

namespace winnow {

using namespace std::chrono_literals;

void ProgressMeter::begin(const char* stage, std::uint64_t total, const char* unit) {
  check_cancelled();
  const std::scoped_lock lock(telling_);
  stage_ = stage;
  unit_ = unit;
  total_ = total;
  done_ = 0;
  next_ = (Clock::now() + 100ms).time_since_epoch().count();
  if (context_.progress) context_.progress({stage_, 0, total_, unit_});
}

ProgressMeter::Inner::Inner(ProgressMeter& meter, const char* stage, std::uint64_t total,
                            const char* unit)
    : meter_(meter),
      stage_(meter.stage_),
      unit_(meter.unit_),
      total_(meter.total_),
      done_(meter.done_) {
  meter.begin(stage, total, unit);
}

ProgressMeter::Inner::~Inner() {
  const std::scoped_lock lock(meter_.telling_);
  meter_.stage_ = stage_;
  meter_.unit_ = unit_;
  meter_.total_ = total_;
  meter_.done_ = done_;
}

void ProgressMeter::advance(std::uint64_t amount) {
  check_cancelled();
  const std::uint64_t done = done_.fetch_add(amount, std::memory_order_relaxed) + amount;
  if (!context_.progress) return;
  const auto now = Clock::now().time_since_epoch().count();
  if (now < next_.load(std::memory_order_relaxed)) return;
  const std::unique_lock lock(telling_, std::try_to_lock);
  if (!lock) return;
  next_ = now + Clock::duration(100ms).count();
  context_.progress({stage_, done, total_, unit_});
}

void ProgressMeter::stop() {
  throw Error(ErrorKind::cancelled, "stopped on request; nothing was written");
}

}  // namespace winnow
