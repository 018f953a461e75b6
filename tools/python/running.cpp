#include "python/running.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace winnow::python {

namespace {

namespace py = pybind11;

// What the thread that works tells the one that waits.
class News {
 public:
  void tell(const Progress& progress) {
    const std::scoped_lock lock(mutex_);
    progress_ = progress;
    changed_.notify_one();
  }
  void end() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }
  // Waits for news, but not so long that signals wait. Whether the call goes on.
  bool wait() {
    constexpr std::chrono::milliseconds patience(50);
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return ended_ || progress_; });
    return !ended_;
  }
  std::optional<Progress> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(progress_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Progress> progress_;
  bool ended_ = false;
};

void answer(News& news, const py::object& progress) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (const std::optional<Progress> now = news.take())
    progress(now->stage, now->done, now->total, now->unit);
}

}  // namespace

void run(Context& context, const py::object& progress, const std::function<void()>& call) {
  News news;
  context.progress = nullptr;
  if (!progress.is_none()) context.progress = [&news](const Progress& now) { news.tell(now); };
  std::exception_ptr failed, raised;
  std::thread worker([&] {
    try {
      call();
    } catch (...) {
      failed = std::current_exception();
    }
    news.end();
  });
  {
    const py::gil_scoped_release unlocked;
    for (bool going = true; going;) {
      going = news.wait();
      if (raised) continue;
      const py::gil_scoped_acquire locked;
      try {
        answer(news, progress);
      } catch (...) {
        raised = std::current_exception();
        context.cancel();
      }
    }
    worker.join();
  }
  context.progress = nullptr;
  context.reset();
  if (raised) std::rethrow_exception(raised);
  if (failed) std::rethrow_exception(failed);
}

}  // namespace winnow::python
