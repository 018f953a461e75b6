#include <winnow/compare_sequence.hpp>
#include <winnow/error.hpp>

#include "numbers.hpp"
#include "program.hpp"
#include "report_json.hpp"
#include "report_text.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

namespace winnow::cli {

namespace {

struct CompareSequenceArguments {
  std::vector<std::string> originals, simplified;
  std::string picture;
  TableOptions<CompareOptions> options{compare_options()};
  CommonOptions common;
};

void show(const SequenceComparison& report, std::ostream& out) {
  const Lines line(out, 12);
  line("frames", grouped(report.frames));
  line("rms", show_length(report.mean_rms) + " in the mean (" +
                  show_length(report.mean_rms_percent) + " % of the diagonal), " +
                  show_length(report.worst_rms) + " at worst, in frame " +
                  grouped(report.worst_frame + 1));
  line("flipped", grouped(report.most_flipped) + " faces of a frame at most");
  line("degenerate", grouped(report.degenerate) + " faces of all frames");
  line("flicker", report.flicker ? show_length(report.flicker->simplified) + ", of the original " +
                                       show_length(report.flicker->original)
                                 : "not measured: that takes three frames with the same vertices");
  line("time",
       show_seconds(report.seconds) + ", peak memory " + human_bytes(report.peak_memory_bytes));
}

void run_compare_sequence(const CompareSequenceArguments& arguments) {
  CompareOptions options;
  arguments.options.read(options);
  options.picture = arguments.picture;
  Context context;
  prepare(context, arguments.common, "-");
  const SequenceComparison report = with_progress(context, arguments.common, [&] {
    return compare_sequence(context, arguments.originals, arguments.simplified, options);
  });
  tell(report, arguments.common, std::cout, show);
}

}  // namespace

// The parser drops "--".
void name_simplified_frames(std::vector<std::string>& words) {
  if (words.empty() || words.front() != "compare-sequence") return;
  std::replace(words.begin(), words.end(), std::string("--"), std::string("--simplified"));
}

void add_compare_sequence(CLI::App& app) {
  auto arguments = std::make_shared<CompareSequenceArguments>();
  CLI::App* command = app.add_subcommand(
      "compare-sequence", "Measure how far a simplified sequence is from its original");
  command->add_option("original", arguments->originals, "The frames of the original, a file each")
      ->required()
      ->type_name("FRAME");
  command
      ->add_option("--simplified", arguments->simplified,
                   "The frames of the simplified sequence, as many; -- is short for it")
      ->required()
      ->type_name("FRAME ...");
  command
      ->add_option(
          "--picture", arguments->picture,
          "Draw up to eight frames beside each other, above as they were, below simplified")
      ->type_name("FILE.png");
  arguments->options.add_to(*command, {"samples", "view", "force"});
  arguments->common.add_to(*command, "TMPDIR, or /var/tmp");
  command->footer(
      "Names that differ in one number alone are put in the order of that, on either side.\n"
      "The flicker is the root mean square of the second difference of positions over time. That "
      "of\n"
      "the original is measured at the points where the simplified vertices lie in the first "
      "frame.\n"
      "Examples:\n"
      "  winnow compare-sequence frame-*.ply -- small-*.ply --json\n"
      "  winnow compare-sequence frame-*.ply -- small-*.ply --picture sheet.png");
  command->callback([arguments] { run_compare_sequence(*arguments); });
}

}  // namespace winnow::cli
