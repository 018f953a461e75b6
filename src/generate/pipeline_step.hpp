// A step of a oneTBB pipeline that ThreadSanitizer understands.
#pragma once

#include <atomic>
#include <utility>

namespace winnow {

// The pipeline itself makes sure that a step sees what was written before the pipeline began. Debian's oneTBB
// is not built for ThreadSanitizer, though, which then takes that for a race; passing the body on through an
// atomic shows it the order. The body must outlive the pipeline.
template <typename Body>
class PipelineStep {
 public:
  explicit PipelineStep(const Body& body) { body_.store(&body, std::memory_order_release); }
  PipelineStep(const PipelineStep& other) {
    body_.store(other.body_.load(std::memory_order_acquire), std::memory_order_release);
  }
  PipelineStep& operator=(const PipelineStep&) = delete;
  ~PipelineStep() = default;

  template <typename Argument>
  auto operator()(Argument&& argument) const {
    return (*body_.load(std::memory_order_acquire))(std::forward<Argument>(argument));
  }

 private:
  std::atomic<const Body*> body_;
};

}  // namespace winnow
