#include "read/indexed/reader.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/for_each_batch.hpp"
#include "read/indexed/locality.hpp"
#include "read/indexed/packed_records.hpp"
#include "read/indexed/slices.hpp"
#include "read/ply/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winnow {

void IndexedReader::begin_positions(PassCorners /*corners*/) {
  if (streams_ != nullptr) streams_->release_memory();
  vertices_.acquire_memory();
  next_position_ = 0;
}

bool IndexedReader::next_positions(RawBatch& batch) {
  batch = {};
  batch.first = next_position_;
  batch.count = std::min<std::uint64_t>(memory_.batch_faces, vertices_.size() - next_position_);
  next_position_ += batch.count;
  return batch.count > 0;
}

void IndexedReader::decode_positions(const RawBatch& batch, FaceBatch& slice,
                                     const PositionSink& sink) const {
  const std::array<double*, 3> out{slice.position[0][0].data(), slice.position[0][1].data(),
                                   slice.position[0][2].data()};
  for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
    const std::size_t count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
    vertices_.read(batch.first + from, count, out);
    sink({{out[0], out[1], out[2]}, count, batch.first + from, 0});
  }
  vertices_.check_intact(source_->name());
}

std::optional<std::array<double, 3>> IndexedReader::first_finite_position() {
  std::array<double, 3> xyz{};
  for (std::uint64_t i = 0; i < vertices_.size(); ++i) {
    vertices_.read(i, 1, {&xyz[0], &xyz[1], &xyz[2]});
    if (std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2])) return xyz;
  }
  return {};
}

namespace {

// The largest number of a type stands for none in many a file.
bool stands_for_none(double size) {
  return !std::isfinite(size) || size == std::numeric_limits<float>::max() ||
         size == std::numeric_limits<double>::max();
}

}  // namespace

std::vector<MeshReader::AttributeRange> IndexedReader::attribute_ranges() {
  const auto& attributes = facts_.choice.carried;
  std::vector<AttributeRange> ranges(attributes.size());
  std::vector<std::size_t> real;
  for (std::size_t k = 0; k < attributes.size(); ++k) {
    const auto bits = static_cast<int>(8 * size_of(attributes[k].type));
    if (is_integer(attributes[k].type)) {
      ranges[k].largest = std::ldexp(1, bits) - 1;
    } else {
      real.push_back(k);
    }
  }
  if (real.empty()) return ranges;
  job_.progress.begin("measure attributes", vertices_.size(), "vertices");
  vertices_.acquire_memory();
  const VertexLayout& layout = vertices_.layout();
  vertices_.for_each_stretch([&](const std::byte* record, std::size_t count) {
    job_.progress.advance(count);
    for (std::size_t i = 0; i < count; ++i, record += layout.stride) {
      for (const std::size_t k : real) {
        const auto [offset, type] = layout.attributes[k];
        const double number = load_real(record + offset, type, layout.swapped);
        if (attributes[k].lacks(number)) continue;
        const double size = std::abs(number);
        if (stands_for_none(size)) {
          ++ranges[k].without;
        } else {
          ranges[k].largest = std::max(ranges[k].largest, size);
        }
      }
    }
  });
  vertices_.check_intact(source_->name());
  return ranges;
}

void IndexedReader::begin_faces() {
  next_face_ = 0;
  held_.clear();
  if (streams_ == nullptr && sorted_ == nullptr) {
    vertices_.acquire_memory();
    if (sampled_ || !vertices_.larger_than_memory()) return begin_indices();
    begin_first_time();
    if (streams_ == nullptr && sorted_ == nullptr) return;
    next_face_ = 0;
  }
  if (sorted_ != nullptr) {
    vertices_.acquire_memory();
    return sorted_->begin();
  }
  vertices_.release_memory();
  streams_->begin();
  if (kept_ == nullptr) begin_indices();
}

bool IndexedReader::next_of_source(RawBatch& batch) {
  batch = {};
  if (!held_.empty()) {
    batch = std::move(held_.front());
    held_.pop_front();
  } else if (!next_indices(batch)) {
    if (!std::exchange(faces_read_, true) && crossed_ > 0) {
      job_.note(grouped(crossed_) + (crossed_ == 1 ? " polygon of '" : " polygons of '") +
                source_->name() +
                "' cross themselves and could not be cut properly; they became fans of triangles");
    }
    return false;
  }
  if (memory_.polygons_as_fans) {
    batch.fans.clear();
  } else {
    cut_polygons(batch);
  }
  batch.first = next_face_;
  next_face_ += batch.count;
  return true;
}

void IndexedReader::cut_polygons(RawBatch& batch) {
  std::vector<std::uint32_t> corners;
  std::vector<Point> positions;
  Pace pace([this] { job_.progress.check_cancelled(); });
  for (const auto& [first, triangles] : std::exchange(batch.fans, {})) {
    std::uint32_t* const fan = batch.indices.data() + 3 * first;
    corners.reserve(triangles + 2);
    corners.assign({fan[0], fan[1]});
    for (std::uint64_t i = 0; i < triangles; ++i) {
      pace();
      corners.push_back(fan[3 * i + 2]);
    }
    // One that has a corner too many is told of as a bad face.
    if (*std::max_element(corners.begin(), corners.end()) >= vertices_.size()) continue;
    positions.resize(corners.size());
    for (std::size_t at = 0; at < corners.size(); at += Pace::steps) {
      pace.ask();
      const std::size_t count = std::min<std::size_t>(Pace::steps, corners.size() - at);
      vertices_.look_up(std::span(corners).subspan(at, count),
                        std::span(positions).subspan(at, count));
    }
    const auto& cut = cutter_.cut(positions);
    if (cut.size() != triangles) {
      crossed_ += faces_read_ ? 0 : 1;
      continue;
    }
    for (std::uint64_t i = 0; i < triangles; ++i) {
      pace();
      for (std::size_t c = 0; c < 3; ++c) fan[3 * i + c] = corners[cut[i][c]];
    }
  }
}

// Batches are of whole polygons, so a large one makes them larger than the plan knows; one of the
// size of a batch may stand behind all but a face of another.
void IndexedReader::reserve_for_batch(std::uint64_t triangles) {
  job_.progress.check_cancelled();
  if (triangles <= std::max<std::uint64_t>(2 * memory_.batch_faces, largest_batch_)) return;
  const std::uint64_t in_flight = 2 * batches_in_flight(job_.threads) * BufferedFaces::bytes_a_face;
  large_polygon_.release();
  large_polygon_ = job_.budget.reserve((triangles + 2) * (in_flight + PolygonCutter::memory(1)),
                                       "a large polygon");
  largest_batch_ = triangles;
}

void IndexedReader::to_indices(RawBatch& batch) const {
  if (!batch.indices.empty()) return;
  corner_numbers(batch, batch.indices);
  batch.status.assign(batch.count, FaceStatus::good);
  batch.block.check_intact(source_->name());
  batch.block = {};
}

bool IndexedReader::next_faces(RawBatch& batch) {
  if (sorted_ == nullptr && kept_ == nullptr) {
    if (!next_of_source(batch)) return false;
    if (streams_ == nullptr) return true;
    to_indices(batch);
  } else {
    batch = {};
    batch.first = next_face_;
    if (sorted_ != nullptr) {
      sorted_->next(memory_.batch_faces, batch);
    } else {
      kept_->read(next_face_, memory_.batch_faces, batch, grow_batch());
    }
    next_face_ += batch.count;
  }
  if (streams_ != nullptr && batch.count > 0) streams_->add_records(batch);
  return batch.count > 0;
}

void IndexedReader::decode_faces(const RawBatch& batch, FaceBatch& slice,
                                 const FaceSink& given) const {
  // A large polygon makes a batch of any size.
  const FaceSink asking = [&](const FaceBatch& one) {
    if (one.first / FaceBatch::capacity % 256 == 0) job_.progress.check_cancelled();
    given(one);
  };
  const FaceSink& sink = batch.count > memory_.batch_faces ? asking : given;
  if (streams_ != nullptr) return slice_records(batch, vertices_, *streams_, slice, sink);
  decode_indices(batch, slice, sink);
  vertices_.check_intact(source_->name());
  batch.block.check_intact(source_->name());
}

void IndexedReader::decode_indices(const RawBatch& batch, FaceBatch& slice,
                                   const FaceSink& sink) const {
  slice_indices(batch, vertices_, slice, sink);
}

void IndexedReader::corner_numbers(const RawBatch& batch,
                                   std::vector<std::uint32_t>& numbers) const {
  numbers.assign(batch.indices.begin(), batch.indices.end());
}

// Streams read and write every corner's number and record twice in all, and the vertices once: in
// long stretches, which is as fast as a disk can be. Sorted faces are a third of that. Lookups read
// pages from anywhere. So a few times as many bytes have to be at stake before it is worth the
// scratch, and a mesh in a sensible order never comes near that.
void IndexedReader::begin_first_time() {
  sampled_ = true;
  constexpr double worth_it = 4;
  // Each of the others costs a few lookups somewhere, as long as they are few.
  constexpr double most_far = 0.01;
  constexpr int stretches = 16;
  constexpr std::size_t first_batches = 4;
  Locality locality(vertices_,
                    SortedFaces::near(vertices_.layout().stride, vertices_.memory_limit()));
  std::vector<std::uint32_t> numbers;
  RawBatch batch;
  bool anywhere = true;
  for (int i = 0; i < stretches && anywhere; ++i) {
    batch = {};
    anywhere = sample_indices(static_cast<double>(i) / (stretches - 1), batch);
    if (!anywhere) break;
    corner_numbers(batch, numbers);
    locality.add_stretch(numbers);
  }
  begin_indices();
  while (!anywhere && held_.size() < first_batches) {
    batch = {};
    if (!next_indices(batch)) break;
    corner_numbers(batch, numbers);
    locality.add_stretch(numbers);
    held_.push_back(std::move(batch));
  }
  const PackedRecords packed(vertices_.layout());
  // A surface has twice as many faces as vertices.
  const std::uint64_t faces = facts_.faces.value_or(2 * vertices_.size());
  const double vertex_bytes =
      static_cast<double>(vertices_.size()) * static_cast<double>(vertices_.layout().stride);
  const double streamed =
      vertex_bytes + static_cast<double>(faces) * 2 *
                         static_cast<double>(CornerStreams::bytes_a_face(packed.size()));
  if (locality.lookup_bytes(faces) < worth_it * streamed) return;
  const std::uint64_t memory = vertices_.memory_limit();
  if (memory_.any_order && locality.far_part() <= most_far) {
    if (const auto plan = SortedFaces::plan(vertices_.size(), vertices_.layout().stride, memory))
      return sort(*plan);
  }
  if (const auto plan = CornerStreams::plan(vertices_.size(), packed.size(), memory, job_.threads))
    bring_together(*plan);
}

void IndexedReader::take_in(const std::function<void(const NextFaces&)>& build) {
  vertices_.release_memory();
  try {
    build([this](RawBatch& batch) { return next_of_source(batch); });
  } catch (const Error& error) {
    // A file that shrinks can look like many other things.
    if (error.kind() == ErrorKind::bad_input) check_whole();
    throw;
  }
  check_whole();
}

void IndexedReader::bring_together(const CornerStreams::Plan& plan) {
  auto streams = std::make_unique<CornerStreams>(job_, vertices_, plan);
  memory_.batch_faces = std::min(memory_.batch_faces, plan.batch_faces);
  if (!faces_come_again()) kept_ = std::make_unique<BufferedFaces>(job_, 0);
  take_in([&](const NextFaces& next) {
    const auto keeping = [&](RawBatch& batch) {
      if (!next(batch)) return false;
      if (kept_ != nullptr) {
        to_indices(batch);
        kept_->add(batch);
      }
      return true;
    };
    streams->build(
        keeping,
        [this](const RawBatch& batch, std::vector<std::uint32_t>& numbers) {
          corner_numbers(batch, numbers);
          batch.block.check_intact(source_->name());
        },
        facts_.faces.value_or(0));
  });
  if (kept_ != nullptr) kept_->finish();
  streams_ = std::move(streams);
}

void IndexedReader::sort(const SortedFaces::Plan& plan) {
  auto sorted = std::make_unique<SortedFaces>(job_, plan);
  take_in([&](const NextFaces& next) {
    sorted->build(
        next, [this](RawBatch& batch) { to_indices(batch); }, facts_.faces.value_or(0));
  });
  sorted_ = std::move(sorted);
}

void IndexedReader::release_memory() {
  vertices_.release_memory();
  if (streams_ != nullptr) streams_->release_memory();
}

}  // namespace winnow
