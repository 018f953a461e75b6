#include "read/for_each_batch.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"

namespace winnow {

namespace {

// The serial step finds the next raw batch, the parallel step decodes and hands it on.
template <typename Next, typename Decode>
bool run_pass(Job& job, Next next, Decode decode, const std::function<bool()>& stop) {
  PerSlot<FaceBatch> slices(job.threads, [] { return std::make_unique<FaceBatch>(); });
  bool more = true;
  pipeline<RawBatch>(
      batches_in_flight(job.threads),
      [&](RawBatch& batch) {
        if (stop && stop()) return false;
        more = next(batch);
        return more;
      },
      [&](RawBatch& batch) {
        decode(batch, slices.local());
        job.progress.advance(batch.count);
        batch = {};  // lets a mapped window go
      });
  return more;
}

// The same with a third, serial step.
template <typename Next, typename Decode>
void run_ordered_pass(Job& job, Next next, Decode decode, const BytesTaker& take) {
  struct Item {
    RawBatch batch;
    BatchBytes bytes;
  };
  PerSlot<FaceBatch> slices(job.threads, [] { return std::make_unique<FaceBatch>(); });
  pipeline<Item>(
      batches_in_flight(job.threads), [&](Item& item) { return next(item.batch); },
      [&](Item& item) {
        item.bytes.clear();
        decode(item.batch, slices.local(), item.bytes);
        job.progress.advance(item.batch.count);
        item.batch = {};  // lets a mapped window go
      },
      [&](const Item& item) { take(item.bytes); });
}

// A file that shrinks can look like many other things, so it is asked about first.
template <typename Pass>
auto watch_the_file(const MeshReader& reader, Pass pass) {
  try {
    const bool more = pass();
    reader.check_whole();
    return more;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::bad_input) reader.check_whole();
    throw;
  }
}

}  // namespace

bool for_each_face_batch(Job& job, MeshReader& reader, const FaceSink& sink,
                         const std::function<bool()>& stop,
                         const std::function<bool(const RawBatch&)>& wanted) {
  for (;;) {
    const bool more = watch_the_file(reader, [&] {
      return run_pass(
          job, [&](RawBatch& batch) { return reader.next_faces(batch); },
          [&](const RawBatch& batch, FaceBatch& slice) {
            if (!wanted || wanted(batch)) reader.decode_faces(batch, slice, sink);
          },
          stop);
    });
    if (more || !reader.next_part()) return more;
  }
}

void for_each_position_batch(Job& job, MeshReader& reader, const PositionSink& sink,
                             PassCorners corners) {
  reader.begin_positions(corners);
  do {
    watch_the_file(reader, [&] {
      return run_pass(
          job, [&](RawBatch& batch) { return reader.next_positions(batch); },
          [&](const RawBatch& batch, FaceBatch& slice) {
            reader.decode_positions(batch, slice, sink);
          },
          {});
    });
  } while (reader.next_part());
}

void for_each_face_batch_in_order(Job& job, MeshReader& reader,
                                  const std::function<void(const FaceBatch&, BatchBytes&)>& encode,
                                  const BytesTaker& take) {
  reader.begin_faces();
  watch_the_file(reader, [&] {
    run_ordered_pass(
        job, [&](RawBatch& batch) { return reader.next_faces(batch); },
        [&](const RawBatch& batch, FaceBatch& slice, BatchBytes& bytes) {
          reader.decode_faces(batch, slice, [&](const FaceBatch& faces) { encode(faces, bytes); });
        },
        take);
    return false;
  });
}

void for_each_position_batch_in_order(
    Job& job, MeshReader& reader,
    const std::function<void(const PositionView&, BatchBytes&)>& encode, const BytesTaker& take) {
  reader.begin_positions(PassCorners::all);
  do {
    watch_the_file(reader, [&] {
      run_ordered_pass(
          job, [&](RawBatch& batch) { return reader.next_positions(batch); },
          [&](const RawBatch& batch, FaceBatch& slice, BatchBytes& bytes) {
            reader.decode_positions(batch, slice,
                                    [&](const PositionView& view) { encode(view, bytes); });
          },
          take);
      return false;
    });
  } while (reader.next_part());
}

}  // namespace winnow
