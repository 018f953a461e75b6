// The ways in which the library runs in parallel: oneTBB's, and under ThreadSanitizer the order
// that they give.
//
// Debian's oneTBB is not built for ThreadSanitizer, which therefore does not see that a task starts
// after what was before its call, and ends before what comes behind it. Each task tells it so, and
// nothing more: tasks that run at the same time stay unordered, and their races are found.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

namespace winnow {

#ifdef __SANITIZE_THREAD__
class TaskOrder {
 public:
  TaskOrder() { tasks_.load(std::memory_order_acquire); }
  ~TaskOrder() { tasks_.fetch_add(1, std::memory_order_release); }
  TaskOrder(const TaskOrder&) = delete;
  TaskOrder& operator=(const TaskOrder&) = delete;

 private:
  static inline std::atomic<unsigned> tasks_{0};
};

// Around a call that runs tasks, however it ends.
class CallOrder {
 public:
  CallOrder() { TaskOrder(); }
  ~CallOrder() { TaskOrder(); }
  CallOrder(const CallOrder&) = delete;
  CallOrder& operator=(const CallOrder&) = delete;
};
#else
struct TaskOrder {};
struct CallOrder {};
#endif

// What travels through a pipeline, owned outside of it: a pipeline that ends with an exception
// drops its items without destroying them, so they are pointers to these.
template <typename Item>
class PipelineItems {
 public:
  Item* take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) {
      owned_.push_back(std::make_unique<Item>());
      free_.push_back(owned_.back().get());
    }
    Item* item = free_.back();
    free_.pop_back();
    return item;
  }

  void give_back(Item* item) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(item);
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Item>> owned_;
  std::vector<Item*> free_;
};

// work(0) to work(count - 1), in any order.
template <typename Work>
void parallel_for(std::size_t count, const Work& work) {
  const auto task = [&work](std::size_t i) {
    [[maybe_unused]] const TaskOrder order;
    work(i);
  };
  [[maybe_unused]] const CallOrder order;
  tbb::parallel_for(std::size_t{0}, count, task);
}

// Steps of a pipeline, joined by `&`: one item at a time and in order, or several at once.
template <typename In, typename Out, typename Work>
tbb::filter<In, Out> step(tbb::filter_mode mode, Work work) {
  return tbb::make_filter<In, Out>(mode, [work = std::move(work)](auto&& item) -> Out {
    [[maybe_unused]] const TaskOrder order;
    return work(std::forward<decltype(item)>(item));
  });
}

// Runs the steps with at most `items` items on their way.
inline void run_pipeline(std::size_t items, const tbb::filter<void, void>& steps) {
  [[maybe_unused]] const CallOrder order;
  tbb::parallel_pipeline(items, steps);
}

// fill(item), in order, one at a time, until it says false; then work(item), several at once.
template <typename Item, typename Fill, typename Work>
void pipeline(std::size_t items, const Fill& fill, const Work& work) {
  PipelineItems<Item> pool;
  run_pipeline(
      items, step<void, Item*>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
               Item* item = pool.take();
               if (!fill(*item)) control.stop();
               return item;
             }) & step<Item*, void>(tbb::filter_mode::parallel, [&](Item* item) {
               work(*item);
               pool.give_back(item);
             }));
}

// The same, and then finish(item), in order, one at a time.
template <typename Item, typename Fill, typename Work, typename Finish>
void pipeline(std::size_t items, const Fill& fill, const Work& work, const Finish& finish) {
  PipelineItems<Item> pool;
  run_pipeline(
      items, step<void, Item*>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
               Item* item = pool.take();
               if (!fill(*item)) control.stop();
               return item;
             }) & step<Item*, Item*>(tbb::filter_mode::parallel, [&](Item* item) {
               work(*item);
               return item;
             }) & step<Item*, void>(tbb::filter_mode::serial_in_order, [&](Item* item) {
               finish(*item);
               pool.give_back(item);
             }));
}

}  // namespace winnow
