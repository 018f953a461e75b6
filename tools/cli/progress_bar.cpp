#include "numbers.hpp"
#include "program.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

namespace winnow::cli {

namespace {

enum Commands : unsigned {
  simplifies = 1,
  converts = 2,
  informs = 4,
  compares = 8,
  generates = 16,
  moves = 32  // a sequence
};

unsigned kind_of(const std::string& command) {
  if (command == "convert") return converts;
  if (command == "info") return informs;
  if (command.starts_with("compare")) return compares;
  if (command == "sequence") return moves;
  return command == "generate" ? generates : simplifies;
}

struct Stage {
  std::string_view name;
  double length;  // about how long it takes, beside the others
  unsigned commands;
};

// In the order in which they come. No run has all of them.
constexpr std::array<Stage, 33> stages{{
    {"go on", 2, simplifies},
    {"copy the input to scratch", 8, simplifies | converts | compares},
    {"read the simplified mesh", 5, compares},
    {"read frames", 40, moves},
    {"order vertices", 3, moves},
    {"read the mesh", 12, simplifies | converts | informs | compares},
    {"keep faces", 5, simplifies | converts},
    {"read vertices", 6, simplifies | converts | informs | compares},
    {"read faces", 20, converts | informs},
    {"measure attributes", 2, simplifies},
    {"measure the original", 15, compares},
    {"count faces", 4, simplifies},
    {"measure", 4, simplifies | converts},
    {"gather vertices", 6, simplifies},
    {"find neighbours", 6, simplifies},
    {"join vertices", 4, simplifies},
    {"sample", 4, simplifies},
    {"cluster", 20, simplifies},
    {"look for damage", 2, simplifies},
    {"read near damage", 8, simplifies},
    {"split cells", 2, simplifies},
    {"weld", 8, simplifies | converts},
    {"join faces", 8, simplifies | converts},
    {"keep", 2, simplifies},
    {"generate", 100, generates},
    {"refine", 30, simplifies | moves},
    {"unfold", 2, simplifies | moves},
    {"compare", 100, compares},
    {"flicker", 5, compares},
    {"check", 2, simplifies},
    {"picture", 3, compares},
    {"pack", 3, simplifies | converts},
    {"write", 5, simplifies | converts | compares | moves},
}};

std::size_t terminal_columns() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

// What fits into so many columns: the head, cut if it must be, the parts that still do, and before
// all a bar.
std::string fitted(const std::string& head, const std::vector<std::string>& parts,
                   std::optional<double> share, std::size_t columns) {
  std::string line = head.substr(0, columns);
  for (const std::string& part : parts) {
    if (!part.empty() && line.size() + 2 + part.size() <= columns) line.append("  ").append(part);
  }
  constexpr std::size_t shortest = 8, longest = 30;
  if (!share || line.size() + 3 + shortest > columns) return line;
  const std::size_t length = std::min(columns - line.size() - 3, longest);
  const auto filled = static_cast<std::size_t>(*share * static_cast<double>(length));
  return "[" + std::string(filled, '#') + std::string(length - filled, '.') + "] " + line;
}

}  // namespace

// How much of the run is done: a guess that never goes back.
class RunShare {
 public:
  explicit RunShare(const std::string& command) : commands_(kind_of(command)) {}

  void begin(std::string_view stage) {
    start_ = at(1);  // what came before is done
    const Stage* const found = std::find_if(stages.begin(), stages.end(),
                                            [&](const Stage& one) { return one.name == stage; });
    double left = 0;
    for (const Stage* next = found; next != stages.end(); ++next) {
      if (next == found || (next->commands & commands_) != 0) left += next->length;
    }
    length_ = found == stages.end() ? 0 : (1 - start_) * found->length / left;
    const auto number = static_cast<std::size_t>(found - stages.begin());
    if (number < next_) length_ *= again;
    next_ = std::max(next_, number + 1);
  }
  double at(double part) { return share_ = std::max(share_, start_ + length_ * part); }

 private:
  static constexpr double again = 0.2;  // what comes again takes so much of what it took first

  unsigned commands_;
  std::size_t next_ = 0;  // behind the last stage that there was
  double share_ = 0, start_ = 0, length_ = 0;
};

struct ProgressBar::State {
  using Clock = std::chrono::steady_clock;

  explicit State(const std::string& command) : share(command) {}

  bool json = false;
  bool terminal = false;
  bool shown = false;
  std::string stage;
  std::uint64_t done = 0;
  RunShare share;
  Clock::time_point run_begin = Clock::now(), begin = Clock::now();

  static double since(Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
  }

  void show(const Progress& progress) {
    // The same stage again, as a round of refinement, begins at 0 again.
    if (stage != progress.stage || progress.done < done) {
      stage = progress.stage;
      begin = Clock::now();
      share.begin(stage);
    }
    done = progress.done;
    const double seconds = since(begin);
    const double part = progress.total == 0
                            ? 0
                            : std::min(1.0, static_cast<double>(progress.done) /
                                                static_cast<double>(progress.total));
    const double whole = share.at(part);
    if (json) {
      const nlohmann::ordered_json line{{"stage", progress.stage}, {"done", progress.done},
                                        {"total", progress.total}, {"unit", progress.unit},
                                        {"seconds", seconds},      {"share", whole}};
      std::cerr << line.dump() + "\n" << std::flush;
      return;
    }
    const double rate = seconds > 0 ? static_cast<double>(progress.done) / seconds : 0;
    const std::string speed = show_rate(rate) + progress.unit + "/s";
    const std::size_t columns = (terminal ? terminal_columns() : 80) - 1;
    std::string line;
    if (progress.total > 0) {
      const double elapsed = since(run_begin);
      const bool known = whole > 0.05 && elapsed > 2;
      std::string head = std::to_string(static_cast<int>(whole * 100)) + " %  ";
      head += progress.stage;
      const std::string left =
          known ? "about " + show_seconds(elapsed * (1 - whole) / whole) + " left" : "";
      line = fitted(head, {left, speed}, whole, columns);
    } else {
      line = fitted(progress.stage, {grouped(progress.done) + " " + progress.unit, speed}, {},
                    columns);
    }
    // One write a line; the rest of an older, longer one is wiped.
    std::cerr << (terminal ? "\r" + line + "\x1b[K" : line + "\n") << std::flush;
    shown = true;
  }

  // The last line of a run that was done.
  void finish() const {
    if (!json) return;
    const nlohmann::ordered_json line{{"stage", "done"}, {"done", 1},
                                      {"total", 1},      {"unit", "run"},
                                      {"share", 1.0},    {"seconds", since(run_begin)}};
    std::cerr << line.dump() + "\n" << std::flush;
  }

  void wipe() {
    if (shown && terminal) std::cerr << "\r\x1b[K" << std::flush;
    shown = false;
  }
};

ProgressBar::ProgressBar(Context& context, const CommonOptions& options)
    : state_(std::make_shared<State>(options.owner->get_name())) {
  state_->terminal = ::isatty(STDERR_FILENO) == 1;
  state_->json = options.progress == "json";
  const bool wanted = options.progress == "always" || state_->json ||
                      (options.progress == "auto" && state_->terminal);
  if (!wanted || (options.quiet && options.progress == "auto")) return;
  context.progress = [state = state_](const Progress& progress) { state->show(progress); };
}

ProgressBar::~ProgressBar() {
  state_->wipe();
  if (std::uncaught_exceptions() == 0) state_->finish();
}

}  // namespace winnow::cli
