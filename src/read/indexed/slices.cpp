#include "read/indexed/slices.hpp"

#include <algorithm>

namespace winnow {

namespace {

// The range of the vertices, all of which there are afterwards; nothing where there is none at all.
std::optional<VertexRange> check_numbers(const VertexStore& vertices,
                                         const std::array<std::uint32_t*, 3>& index,
                                         FaceBatch& slice) {
  const std::uint64_t size = vertices.size();
  slice.index = {index[0], index[1], index[2]};
  // As signed numbers, which the plainest vector instructions compare.
  constexpr std::uint32_t sign = 1U << 31;
  std::int32_t low = INT32_MAX;
  std::int32_t high = INT32_MIN;
  for (std::size_t i = 0; i < slice.count; ++i) {
    const auto a = static_cast<std::int32_t>(index[0][i] ^ sign);
    const auto b = static_cast<std::int32_t>(index[1][i] ^ sign);
    const auto c = static_cast<std::int32_t>(index[2][i] ^ sign);
    low = std::min({low, a, b, c});
    high = std::max({high, a, b, c});
  }
  VertexRange range{static_cast<std::uint32_t>(low) ^ sign,
                    static_cast<std::uint32_t>(high) ^ sign};
  if (slice.count > 0 && range.highest >= size) {
    for (std::size_t i = 0; i < slice.count; ++i) {
      if (slice.status[i] != FaceStatus::good) continue;
      for (const std::uint32_t* corner : index) {
        if (corner[i] >= size) slice.status[i] = FaceStatus::out_of_range;
      }
    }
    slice.all_good = false;
    if (size == 0) {
      slice.single = false;
      for (auto& corner : slice.position) {
        for (auto& axis : corner) std::fill_n(axis.begin(), slice.count, 0.0);
      }
      return {};
    }
    range = {UINT32_MAX, 0};
    for (std::uint32_t* corner : index) {
      for (std::size_t i = 0; i < slice.count; ++i) {
        corner[i] = corner[i] >= size ? 0 : corner[i];
        range = {std::min(range.lowest, corner[i]), std::max(range.highest, corner[i])};
      }
    }
  }
  return range;
}

}  // namespace

void gather_checked(const VertexStore& vertices, const std::array<std::uint32_t*, 3>& index,
                    FaceBatch& slice) {
  if (const auto range = check_numbers(vertices, index, slice))
    vertices.gather({index[0], index[1], index[2]}, *range, slice.count, slice);
}

namespace {

// Cuts `batch` into slices; `fill` fills one, whose first face has the given number in the batch.
template <typename Fill>
void for_each_slice(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink, Fill fill) {
  for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
    slice.count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
    slice.first = batch.first + from;
    slice.numbers = batch.numbers.empty() ? nullptr : &batch.numbers[from];
    slice.all_good = true;
    for (std::size_t i = 0; i < slice.count; ++i) {
      slice.status[i] = batch.status[from + i];
      slice.all_good &= slice.status[i] == FaceStatus::good;
    }
    slice.single = false;
    fill(from);
    sink(slice);
  }
}

// The same with the vertices' numbers side by side.
template <typename Fill>
void for_each_slice_of_indices(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink,
                               Fill fill) {
  std::array<std::array<std::uint32_t, FaceBatch::capacity>, 3> index;
  for_each_slice(batch, slice, sink, [&](std::uint64_t from) {
    for (std::size_t i = 0; i < slice.count; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        index[corner][i] = batch.indices[3 * (from + i) + corner];
      }
    }
    fill({index[0].data(), index[1].data(), index[2].data()});
  });
}

}  // namespace

void slice_indices(const RawBatch& batch, const VertexStore& vertices, FaceBatch& slice,
                   const FaceSink& sink) {
  for_each_slice_of_indices(batch, slice, sink, [&](const std::array<std::uint32_t*, 3>& index) {
    gather_checked(vertices, index, slice);
  });
}

void slice_records(const RawBatch& batch, const VertexStore& vertices, const CornerStreams& streams,
                   FaceBatch& slice, const FaceSink& sink) {
  CornerStreams::Cursors cursors = batch.records_begin;
  for_each_slice_of_indices(batch, slice, sink, [&](const std::array<std::uint32_t*, 3>& index) {
    check_numbers(vertices, index, slice);
    streams.gather(batch, cursors, {index[0], index[1], index[2]}, slice.count, slice);
  });
}

void slice_corners(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) {
  for_each_slice(batch, slice, sink, [&](std::uint64_t from) {
    for (std::size_t i = 0; i < slice.count; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          slice.position[corner][axis][i] = batch.corners[9 * (from + i) + 3 * corner + axis];
        }
      }
    }
  });
}

void corners_as_positions(const FaceBatch& slice, const PositionSink& sink) {
  std::array<std::array<double, FaceBatch::capacity>, 3> wide;
  for (unsigned number = 0; number < 3; ++number) {
    const auto& corner = slice.position[number];
    PositionView view{{corner[0].data(), corner[1].data(), corner[2].data()},
                      slice.count,
                      slice.first,
                      number,
                      true};
    for (std::size_t axis = 0; axis < 3 && slice.single; ++axis) {
      std::copy_n(slice.single_position[number][axis].begin(), slice.count, wide[axis].begin());
      view.axis[axis] = wide[axis].data();
    }
    sink(view);
  }
}

}  // namespace winnow
