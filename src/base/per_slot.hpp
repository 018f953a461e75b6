// One object for each thread that works in the job's arena.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <tbb/task_arena.h>

namespace winnow {

// By the arena's slots, not by threads: however many threads come and go, there are never more
// objects than the plan has room for. Made on first use. Only for code that runs inside the arena.
template <typename T>
class PerSlot {
 public:
  PerSlot(unsigned slots, std::function<std::unique_ptr<T>()> make)
      : make_(std::move(make)), objects_(slots) {}

  T& local() {
    std::unique_ptr<T>& mine =
        objects_[static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())];
    if (mine == nullptr) mine = make_();
    return *mine;
  }

  // Those that were made.
  [[nodiscard]] std::vector<T*> all() const {
    std::vector<T*> made;
    for (const auto& object : objects_) {
      if (object != nullptr) made.push_back(object.get());
    }
    return made;
  }

  void clear() {
    for (auto& object : objects_) object.reset();
  }

 private:
  std::function<std::unique_ptr<T>()> make_;
  std::vector<std::unique_ptr<T>> objects_;
};

}  // namespace winnow
