// STL: which form it has.
#include "read/stl/reader.hpp"

namespace winnow {

namespace {

std::unique_ptr<MeshReader> open_stl(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, const AttributeRequest& wish,
                                     bool asked) {
  choose_attributes(wish, {}, source->name());  // for its checks: there are none
  const StlHead head = look_at_stl(*source, asked);
  return head.ascii ? make_ascii_stl_reader(job, std::move(source), memory, head)
                    : make_binary_stl_reader(job, std::move(source), memory, head);
}

void probe_stl(Job& /*job*/, ByteSource& source, bool asked, InputProbe& probe) {
  probe.facts = facts_of(look_at_stl(source, asked));
}

}  // namespace

const InputFormat stl_input{
    .reading = Reading::faces, .open = open_stl, .probe = probe_stl, .match = match_stl};

}  // namespace winnow
