// What the inside of the library runs in, for tests that call it directly.
#pragma once

#include <winnow/context.hpp>
#include <winnow/error.hpp>

#include "io/job.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <thread>

#include <catch2/catch.hpp>

namespace winnow::test {

struct JobSettings {
  std::uint64_t memory = std::uint64_t{512} << 20;
  unsigned threads = 2;
  bool map_input = false;
};

// A context and its job.
class TestJob {
 public:
  explicit TestJob(const JobSettings& settings = {}) : context(settings), job(context) {}

 private:
  struct Prepared : Context {
    explicit Prepared(const JobSettings& settings) {
      memory = settings.memory;
      threads = settings.threads;
      map_input = settings.map_input;
      scratch = std::filesystem::temp_directory_path().string();
    }
  };

 public:
  Prepared context;
  Job job;
};

// Cancels what runs in `context` in a while; the context must outlive the thread.
[[nodiscard]] inline std::jthread cancel_later(
    Context& context, std::chrono::milliseconds wait = std::chrono::milliseconds(150)) {
  return std::jthread([&context, wait] {
    std::this_thread::sleep_for(wait);
    context.cancel();
  });
}

// The Error that `call` throws; there has to be one.
template <typename Call>
Error error_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  FAIL("no Error was thrown");
  return {ErrorKind::failed, ""};
}

}  // namespace winnow::test
