// What the targets run in.
#pragma once

#include <winnow/error.hpp>

#include "io/job.hpp"

#include <filesystem>
#include <utility>

namespace winnow::fuzz {

struct FuzzJob {
  FuzzJob() : job(prepared()) {}

 private:
  Context context_;
  Context& prepared() {
    context_.memory = std::uint64_t{64} << 20;
    context_.threads = 1;
    context_.scratch = std::filesystem::temp_directory_path().string();
    return context_;
  }

 public:
  Job job;
};

// Whether `call` came to its end; the other end is an Error about the input.
template <typename Call>
bool survives(Call&& call) {
  try {
    std::forward<Call>(call)();
    return true;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input && error.kind() != ErrorKind::resources) throw;
    return false;
  }
}

}  // namespace winnow::fuzz
