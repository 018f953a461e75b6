#include "numbers.hpp"
#include "program.hpp"

#include <chrono>
#include <cstring>
#include <iostream>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace winnow::cli {

struct ProgressBar::State {
  using Clock = std::chrono::steady_clock;

  bool json = false;
  bool terminal = false;
  bool shown = false;
  std::string stage;
  Clock::time_point begin = Clock::now();

  void show(const Progress& progress) {
    if (stage != progress.stage) {
      stage = progress.stage;
      begin = Clock::now();
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (json) {
      const nlohmann::ordered_json line{{"stage", progress.stage},
                                        {"done", progress.done},
                                        {"total", progress.total},
                                        {"unit", progress.unit},
                                        {"seconds", seconds}};
      std::cerr << line.dump() + "\n" << std::flush;
      return;
    }
    const double rate = seconds > 0 ? static_cast<double>(progress.done) / seconds : 0;
    std::string line = std::string(progress.stage) + " ";
    if (progress.total > 0) {
      const double part =
          std::min(1.0, static_cast<double>(progress.done) / static_cast<double>(progress.total));
      constexpr int width = 30;
      const int filled = static_cast<int>(part * width);
      line += "[" + std::string(static_cast<std::size_t>(filled), '#') +
              std::string(static_cast<std::size_t>(width - filled), '.') + "] ";
      line += std::to_string(static_cast<int>(part * 100)) + " %  " + show_rate(rate) + progress.unit + "/s";
      if (rate > 0 && seconds > 1)
        line += "  " + show_seconds(static_cast<double>(progress.total) * (1 - part) / rate) + " left";
    } else {
      line += show_count(progress.done) + " " + progress.unit + "  " + show_rate(rate) + progress.unit + "/s";
    }
    // One write a line; the rest of an older, longer one is wiped.
    std::cerr << (terminal ? "\r" + line + "\x1b[K" : line + "\n") << std::flush;
    shown = true;
  }

  void wipe() {
    if (shown && terminal) std::cerr << "\r\x1b[K" << std::flush;
    shown = false;
  }
};

ProgressBar::ProgressBar(Context& context, const CommonOptions& options) : state_(std::make_shared<State>()) {
  state_->terminal = ::isatty(STDERR_FILENO) == 1;
  state_->json = options.progress == "json";
  const bool wanted =
      options.progress == "always" || state_->json || (options.progress == "auto" && state_->terminal);
  if (!wanted || (options.quiet && options.progress == "auto")) return;
  context.progress = [state = state_](const Progress& progress) { state->show(progress); };
}

ProgressBar::~ProgressBar() {
  state_->wipe();
}

}  // namespace winnow::cli
