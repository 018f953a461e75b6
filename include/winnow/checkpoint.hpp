// Simplify a mesh or a sequence, or make a progressive file, so that a run that was killed can go
// on.
#pragma once

#include <winnow/api.hpp>
#include <winnow/progressive.hpp>
#include <winnow/sequence.hpp>
#include <winnow/simplify.hpp>

#include <string>
#include <vector>

namespace winnow {

// Where a run keeps what it has done.
struct Checkpoint {
  // A directory for this run alone: one that is empty, or a new one in a directory that exists.
  // Ought to be on a disk with room for the clustered mesh twice (48 bytes a vertex and 12 a face;
  // with an error to meet 80 a vertex more) and 56 bytes for each edge collapsed.
  std::string directory;
  // Leave the files there when the run is done, instead of removing them: resume() then writes the
  // output again.
  bool keep = false;
};

// The same as simplify() without a checkpoint, and the same bytes; but when it is killed at any
// moment, or fails for want of room, resume() goes on from the last stage that was done:
// clustering, each round of refinement, each tile in a round. Until clustering is done nothing is
// kept: resume() reads the input again, which it can not if that was a pipe.
//
// Throws Error as simplify() does; usage also where the directory cannot be used or holds another
// run's checkpoint; resources where another run works in it.
WINNOW_API SimplifyReport simplify(Context& context, const std::vector<std::string>& inputs,
                                   const std::string& output, const SimplifyOptions& options,
                                   const Checkpoint& settings);

// Goes on with the run that `settings.directory` is of, with the options it had; memory, threads
// and scratch are those of `context`. Report: of the whole run, but seconds, scratch and memory of
// this call.
//
// Throws Error as simplify() does; bad_input also where there is no checkpoint, it is damaged or of
// another version of winnow, or the input is not what it was; resources where its run is still
// alive; usage where it is one of another call.
WINNOW_API SimplifyReport resume(Context& context, const Checkpoint& settings);

// The same of progressive(). What is kept is each round, too.
WINNOW_API ProgressiveReport progressive(Context& context, const std::vector<std::string>& inputs,
                                         const std::string& output,
                                         const ProgressiveOptions& options,
                                         const Checkpoint& settings);
WINNOW_API ProgressiveReport resume_progressive(Context& context, const Checkpoint& settings);

// The same of simplify_sequence() from files. Until all frames are read nothing is kept. Then the
// directory takes at most 72 bytes for each vertex of each frame, and 16 for each number that it
// carries. Frames that were written to files of their own are not written again.
WINNOW_API SequenceReport simplify_sequence(Context& context,
                                            const std::vector<std::string>& inputs,
                                            const std::string& output,
                                            const SequenceOptions& options,
                                            const Checkpoint& settings);
WINNOW_API SequenceReport resume_sequence(Context& context, const Checkpoint& settings);

// The calls that can be resumed.
enum class ResumableCall { simplify, progressive, sequence };
// Which of them the run is one of that this directory is of. `simplify` where there is none, or it
// cannot be read: then resume() tells why.
WINNOW_API ResumableCall call_of(const Checkpoint& settings);

}  // namespace winnow
