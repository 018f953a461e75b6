#include "mesh/vertex_map.hpp"

#include "io/recent_blocks.hpp"
#include "io/spool_records.hpp"

namespace winnow {

std::unique_ptr<Spool> composed(Job& job, const Spool& first, const Spool& then,
                                std::uint64_t memory) {
  auto both = std::make_unique<Spool>(job, memory);
  RecentBlocks further(then, sizeof(Destination));
  SpoolCursor<Destination> cursor(job, first);
  Appender<Destination> append(job, *both);
  for (Destination at = 0; cursor.next(at);)
    append.add(at == nowhere ? nowhere : further.at<Destination>(at));
  append.flush();
  both->finish();
  return both;
}

}  // namespace winnow
