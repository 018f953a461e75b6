#include <winnow/checkpoint.hpp>

#include "program.hpp"
#include "progressive_report.hpp"
#include "sequence_report.hpp"
#include "simplify_report.hpp"

#include <memory>

namespace winnow::cli {

namespace {

struct ResumeArguments {
  Checkpoint checkpoint;
  CommonOptions common;
};

void run_resume(const ResumeArguments& arguments) {
  Context context;
  prepare(context, arguments.common, "-");
  if (!arguments.common.surroundings.given("scratch"))
    context.scratch.clear();  // that is the checkpoint's directory
  const auto go_on = [&](const auto& call) {
    tell(with_progress(context, arguments.common,
                       [&] { return call(context, arguments.checkpoint); }),
         arguments.common);
  };
  switch (call_of(arguments.checkpoint)) {
    case ResumableCall::simplify:
      return go_on(resume);
    case ResumableCall::progressive:
      return go_on(resume_progressive);
    case ResumableCall::sequence:
      return go_on(resume_sequence);
  }
}

}  // namespace

void add_resume(CLI::App& app) {
  auto arguments = std::make_shared<ResumeArguments>();
  CLI::App* command = app.add_subcommand(
      "resume",
      "Go on with a run of simplify, progressive or sequence --checkpoint that was killed");
  command
      ->add_option("directory", arguments->checkpoint.directory,
                   "The directory that --checkpoint named")
      ->required()
      ->type_name("DIR");
  command->add_flag("--keep-checkpoint", arguments->checkpoint.keep,
                    "Leave the files in DIR when the run is done (default: they are removed)");
  arguments->common.add_to(*command, "the checkpoint's");
  command->footer(
      "Input, output and options are those of the run, and the output gets the same bytes.\n"
      "The run goes on after the last stage that was done: the input read and clustered, each "
      "round of\n"
      "refinement, each tile in a round. If the input was not read to its end, the run starts "
      "again; a\n"
      "pipe cannot be read again.\n"
      "Checkpoints of 'progressive' and of 'sequence' are taken up the same way. Frames that "
      "'sequence'\n"
      "has written to files of their own are not written again.\n"
      "The exit code is 3 for a checkpoint that is damaged, and 4 for one in use.\n"
      "\nExamples:\n"
      "  winnow simplify scan.ply -o small.ply --faces 100M --checkpoint kept\n"
      "  winnow resume kept");
  command->callback([arguments] { run_resume(*arguments); });
}

}  // namespace winnow::cli
