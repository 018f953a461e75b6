#include "read/indexed/vertex_store.hpp"

#include <winnow/error.hpp>

#include "base/memory_shares.hpp"
#include "base/text.hpp"
#include "io/file_descriptor.hpp"
#include "read/indexed/gather_positions.hpp"
#include "read/ply/scalar.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace winnow {

void VertexStore::ResidentBlocks::reset(std::uint64_t bytes) {
  touched_ = std::vector<std::atomic<std::uint8_t>>((bytes >> block_bits) + 2);
  resident_ = 0;
}

template <typename First>
std::uint64_t VertexStore::ResidentBlocks::touch(std::uint64_t begin, std::uint64_t end,
                                                 const First& first) {
  for (std::uint64_t block = begin >> block_bits; block <= end >> block_bits; ++block) {
    if (touched_[block].load(std::memory_order_relaxed) == 0 && touched_[block].exchange(1) == 0) {
      resident_ += std::uint64_t{1} << block_bits;
      first(block << block_bits, (block + 1) << block_bits);
    }
  }
  return resident_.load(std::memory_order_relaxed);
}

void VertexStore::ResidentBlocks::clear() {
  for (auto& block : touched_) block.store(0, std::memory_order_relaxed);
  resident_ = 0;
}

VertexStore::~VertexStore() {
  if (fd_ >= 0) ::close(fd_);
}

void VertexStore::open_mapping(const std::string& path, std::uint64_t offset, std::uint64_t bytes) {
  file_ = std::make_unique<boost::interprocess::file_mapping>(map_file(path));
  window_ = std::make_unique<MappedWindow>(*file_, offset, bytes);
  file_offset_ = offset;
  ahead_ = std::make_unique<ReadAhead>(file_->get_mapping_handle().handle, offset + bytes);
  watched_ = bytes > memory_limit_;
  resident_limit_ = std::min(bytes, memory_limit_);
  acquire_memory();
  if (!watched_) {
    if (scratch_ != nullptr) scratch_->check(offset, bytes);
    return;
  }
  resident_.reset(bytes);
  fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd_ < 0)
    throw Error(cannot_open(errno), "cannot open '" + path + "': " + std::strerror(errno));
}

void VertexStore::map(const std::string& path, std::uint64_t offset, std::uint64_t count,
                      const VertexLayout& layout, std::shared_ptr<const ScratchFile> scratch) {
  copied_ = std::move(scratch);
  scratch_ = copied_.get();
  count_ = count;
  layout_ = layout;
  if (count > 0) open_mapping(path, offset, count * layout.stride);
}

void VertexStore::look_in(const std::byte* records, std::uint64_t count,
                          const VertexLayout& layout) {
  given_ = records;
  count_ = count;
  layout_ = layout;
}

void VertexStore::begin_keeping(bool double_positions, std::span<const NumberType> attributes) {
  const std::size_t size = double_positions ? sizeof(double) : sizeof(float);
  const PlyType type = double_positions ? PlyType::float64 : PlyType::float32;
  layout_ = {3 * size, {0, size, 2 * size}, {type, type, type}, false, {}};
  for (const NumberType attribute : attributes) {
    layout_.attributes.push_back({layout_.stride, attribute});
    layout_.stride += size_of(attribute);
  }
  kept_ = std::make_unique<Spool>(job_, memory_limit_);
  count_ = 0;
}

namespace {

// As a binary file has it: what is not finite stays so where the type can say it. Text may have
// such where it promised whole numbers.
void store_real(double value, NumberType type, std::byte* at) {
  if (type == NumberType::float64) {
    std::memcpy(at, &value, sizeof value);
  } else if (type == NumberType::float32) {
    const auto single = static_cast<float>(value);
    std::memcpy(at, &single, sizeof single);
  } else {
    store_rounded(std::isnan(value) ? 0 : value, type, at);
  }
}

}  // namespace

void VertexStore::keep(std::span<const double> xyz, std::span<const double> attributes) {
  const std::size_t count = xyz.size() / 3;
  count_ += count;
  const bool plain = layout_.attributes.empty();
  if (plain && layout_.type[0] == PlyType::float64) return kept_->append(std::as_bytes(xyz));
  packed_.resize(count * layout_.stride);
  if (plain) {
    for (std::size_t i = 0; i < xyz.size(); ++i) {
      const auto value = static_cast<float>(xyz[i]);
      std::memcpy(packed_.data() + i * sizeof value, &value, sizeof value);
    }
    return kept_->append(packed_);
  }
  std::byte* record = packed_.data();
  for (std::size_t i = 0; i < count; ++i, record += layout_.stride) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      store_real(xyz[3 * i + axis], layout_.type[axis], record + layout_.offset[axis]);
    for (std::size_t k = 0; k < layout_.attributes.size(); ++k) {
      store_real(attributes[layout_.attributes.size() * i + k], layout_.attributes[k].type,
                 record + layout_.attributes[k].offset);
    }
  }
  kept_->append(packed_);
}

void VertexStore::finish_keeping() {
  kept_->finish();
  if (kept_->in_memory()) return;
  scratch_ = &kept_->file();
  open_mapping(scratch_->path(), 0, kept_->size());
}

namespace {

template <typename Real>
constexpr PlyType real_type = sizeof(Real) == 4 ? PlyType::float32 : PlyType::float64;

template <typename Real>
bool is_plain(const VertexLayout& layout) {
  const auto [x, y, z] = layout.offset;
  return !layout.swapped && y == x + sizeof(Real) && z == y + sizeof(Real) &&
         std::all_of(layout.type.begin(), layout.type.end(),
                     [](PlyType t) { return t == real_type<Real>; });
}

void load_attributes(const std::byte* record, const VertexLayout& layout, std::size_t corner,
                     std::size_t face, FaceBatch& out) {
  if (layout.attributes.empty()) return;
  double* at = out.attributes.data() + corner * FaceBatch::capacity + face;
  for (const VertexLayout::Number& number : layout.attributes) {
    *at = load_real(record + number.offset, number.type, layout.swapped);
    at += 3 * FaceBatch::capacity;
  }
}

[[noreturn]] void cannot_read(std::uint64_t at) {
  throw Error(ErrorKind::bad_input, "cannot read a vertex at byte " + grouped(at) +
                                        "; was the file shortened while it was read?");
}

}  // namespace

void VertexStore::gather_records(const std::byte* records, const VertexLayout& layout,
                                 const std::array<const std::uint32_t*, 3>& index,
                                 std::size_t count, FaceBatch& out) const {
  out.single = is_plain<float>(layout) || floats_;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    if (floats_) {
      gather_doubles(records, layout.stride, index[corner], count, out.single_position[corner]);
    } else if (out.single) {
      gather_floats(records + layout.offset[0], layout.stride, index[corner], count,
                    out.single_position[corner]);
    } else if (is_plain<double>(layout)) {
      gather_doubles(records + layout.offset[0], layout.stride, index[corner], count,
                     out.position[corner]);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        const std::byte* record = records + std::size_t{index[corner][i]} * layout.stride;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          out.position[corner][axis][i] =
              load_real(record + layout.offset[axis], layout.type[axis], layout.swapped);
        }
      }
    }
  }
  out.attributes.resize(3 * FaceBatch::capacity * layout.attributes.size());
  if (layout.attributes.empty()) return;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < count; ++i)
      load_attributes(records + std::size_t{index[corner][i]} * layout.stride, layout, corner, i,
                      out);
  }
}

Point VertexStore::position_of(const std::byte* record) const {
  Point position{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value =
        load_real(record + layout_.offset[axis], layout_.type[axis], layout_.swapped);
    position[axis] = floats_ ? double{static_cast<float>(value)} : value;
  }
  return position;
}

void VertexStore::look_up(std::span<const std::uint32_t> vertices, std::span<Point> out) const {
  const std::byte* records = window_ == nullptr ? in_memory()
                             : reservation_     ? window_->data()
                                                : nullptr;
  const bool floats = is_plain<float>(layout_);
  std::vector<std::byte> record(records == nullptr ? layout_.stride : 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint64_t at = std::uint64_t{vertices[i]} * layout_.stride;
    if (records == nullptr) {
      read_at(file_offset_ + at, record);
      out[i] = position_of(record.data());
      continue;
    }
    if (watched_) touch(at, at + layout_.stride);
    if (floats) {
      std::array<float, 3> xyz;
      std::memcpy(xyz.data(), records + at + layout_.offset[0], sizeof xyz);
      out[i] = {double{xyz[0]}, double{xyz[1]}, double{xyz[2]}};
    } else {
      out[i] = position_of(records + at);
    }
  }
}

void VertexStore::gather_by_reading(const std::array<const std::uint32_t*, 3>& index,
                                    std::size_t count, FaceBatch& out) const {
  std::vector<std::byte> record(layout_.stride);
  out.single = false;
  out.attributes.resize(3 * FaceBatch::capacity * layout_.attributes.size());
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t at = file_offset_ + std::uint64_t{index[corner][i]} * layout_.stride;
      read_at(at, record);
      const Point position = position_of(record.data());
      for (std::size_t axis = 0; axis < 3; ++axis) out.position[corner][axis][i] = position[axis];
      load_attributes(record.data(), layout_, corner, i, out);
    }
  }
}

void VertexStore::gather(const std::array<const std::uint32_t*, 3>& index, VertexRange range,
                         std::size_t count, FaceBatch& out) const {
  if (count == 0) return;
  if (window_ == nullptr) return gather_records(in_memory(), layout_, index, count, out);
  ahead_->reached(file_offset_ + range.lowest * layout_.stride,
                  file_offset_ + (range.highest + std::uint64_t{1}) * layout_.stride);
  if (watched_) {
    const std::uint64_t begin = range.lowest * layout_.stride;
    const std::uint64_t end = range.highest * layout_.stride + layout_.stride;
    if (too_wide(range)) return gather_by_reading(index, count, out);
    touch(begin, end);
  }
  gather_records(window_->data(), layout_, index, count, out);
}

void VertexStore::touch(std::uint64_t begin, std::uint64_t end) const {
  const auto check = [this](std::uint64_t from, std::uint64_t to) {
    if (scratch_ != nullptr) scratch_->check(file_offset_ + from, to - from);
  };
  if (resident_.touch(begin, end, check) <= share::reading::touched(memory_limit_)) return;
  const std::scoped_lock lock(dropping_);
  resident_.clear();
  window_->drop_pages();
  resident_.touch(begin, end, check);
}

const std::byte* VertexStore::stretch(std::uint64_t first, std::size_t count) const {
  const std::uint64_t begin = first * layout_.stride;
  if (window_ == nullptr) return in_memory() + begin;
  const std::uint64_t end = begin + count * layout_.stride;
  ahead_->reached(file_offset_ + begin, file_offset_ + end);
  if (watched_) touch(begin, end);
  return window_->data() + begin;
}

void VertexStore::for_each_stretch(
    const std::function<void(const std::byte*, std::size_t)>& each) const {
  constexpr std::uint64_t at_once = 1024;
  for (std::uint64_t first = 0; first < count_; first += at_once) {
    const std::size_t count = std::min(at_once, count_ - first);
    each(stretch(first, count), count);
    job_.progress.check_cancelled();
  }
}

void VertexStore::read(std::uint64_t first, std::size_t count,
                       const std::array<double*, 3>& out) const {
  const std::byte* base = stretch(first, count);
  if (is_plain<float>(layout_)) {
    for (std::size_t i = 0; i < count; ++i) {
      std::array<float, 3> xyz;
      std::memcpy(xyz.data(), base + i * layout_.stride + layout_.offset[0], sizeof xyz);
      for (std::size_t axis = 0; axis < 3; ++axis) out[axis][i] = xyz[axis];
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = load_real(base + i * layout_.stride + layout_.offset[axis],
                                     layout_.type[axis], layout_.swapped);
      out[axis][i] = floats_ ? double{static_cast<float>(value)} : value;
    }
  }
}

void VertexStore::read_attributes(std::uint64_t first, std::size_t count,
                                  std::vector<double>& out) const {
  const std::byte* record = stretch(first, count);
  for (std::size_t i = 0; i < count; ++i, record += layout_.stride) {
    for (const VertexLayout::Number& number : layout_.attributes)
      out.push_back(load_real(record + number.offset, number.type, layout_.swapped));
  }
}

void VertexStore::read_records(std::uint64_t first, std::size_t count, std::byte* out) const {
  read_at(file_offset_ + first * layout_.stride, {out, count * layout_.stride});
}

void VertexStore::read_at(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (scratch_ != nullptr) return scratch_->read(offset, bytes);
  while (!bytes.empty()) {
    const ssize_t done = ::pread(fd_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) cannot_read(offset);
    offset += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

void VertexStore::release_memory() {
  if (window_ == nullptr) return;
  window_->drop_pages();
  if (watched_) resident_.clear();
  reservation_.release();
}

void VertexStore::acquire_memory() {
  if (window_ == nullptr) return;
  ahead_->start_again();
  if (reservation_) return;
  reservation_ = job_.budget.reserve(resident_limit_, "looking up vertices");
}

void VertexStore::check_intact(const std::string& name) const {
  if (window_ != nullptr && window_->damaged()) {
    throw Error(ErrorKind::bad_input,
                "'" + name +
                    "' was shortened by another program while its vertices were read; "
                    "run again when it is whole");
  }
}

}  // namespace winnow
