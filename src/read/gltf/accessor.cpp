#include "read/gltf/accessor.hpp"

#include <winnow/error.hpp>

#include "read/ply/scalar.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

namespace {

constexpr std::size_t at_once = 8192;

// Glossary of the glTF 2.0 specification, 3.11: "accessor data types".
double component(const std::byte* at, GltfType type, bool normalized) {
  switch (type) {
    case GltfType::int8: {
      const double value = load<std::int8_t>(at, false);
      return normalized ? std::max(value / 127, -1.0) : value;
    }
    case GltfType::uint8: {
      const double value = load<std::uint8_t>(at, false);
      return normalized ? value / 255 : value;
    }
    case GltfType::int16: {
      const double value = load<std::int16_t>(at, false);
      return normalized ? std::max(value / 32767, -1.0) : value;
    }
    case GltfType::uint16: {
      const double value = load<std::uint16_t>(at, false);
      return normalized ? value / 65535 : value;
    }
    case GltfType::uint32:
      return load<std::uint32_t>(at, false);
    case GltfType::float32:
      return load<float>(at, false);
  }
  return 0;
}

bool is_index(GltfType type) {
  return type == GltfType::uint8 || type == GltfType::uint16 || type == GltfType::uint32;
}

}  // namespace

// Whole numbers of normals, colours and rotations are normalized, by the specification; some
// programs forget to say so.
GltfElements::GltfElements(GltfBytes& bytes, const GltfDocument& document, std::size_t accessor,
                           GltfUse use, std::string name)
    : bytes_(bytes),
      document_(document),
      accessor_(document.accessors[accessor]),
      normalized_(use == GltfUse::positions || use == GltfUse::vectors || use == GltfUse::numbers ||
                          use == GltfUse::color_moves
                      ? accessor_.normalized
                      : use != GltfUse::indices),
      name_(std::move(name)) {
  check(use);
  const auto& sparse = accessor_.sparse;
  if (sparse && !is_index(sparse->index_type)) fail("sparse indices are no unsigned integers");
  if (sparse && sparse->count > accessor_.count)
    fail("an accessor has more sparse elements than elements");
  // Zeros without end from a few bytes: nobody means that.
  if (!accessor_.base && use != GltfUse::numbers &&
      accessor_.count > (sparse ? 1024 * sparse->count : 0) + 1024)
    fail("an accessor has no data");
}

// What the specification and KHR_mesh_quantization allow.
void GltfElements::check(GltfUse use) const {
  const GltfType type = accessor_.type;
  const bool scalars = use == GltfUse::indices || use == GltfUse::numbers;
  const unsigned wanted = scalars ? 1 : use == GltfUse::rotations ? 4 : 3;
  const bool colors = use == GltfUse::colors || use == GltfUse::color_moves;
  if (accessor_.components != wanted && !(colors && accessor_.components == 4))
    fail("an accessor is of the wrong type for what it is used for");
  if (use == GltfUse::indices && !is_index(type)) fail("indices are no unsigned integers");
  if (use == GltfUse::positions && type == GltfType::uint32)
    fail("positions are 32-bit integers, which is not allowed");
  const bool real = type == GltfType::float32;
  if (use == GltfUse::normals && !real && type != GltfType::int8 && type != GltfType::int16)
    fail(
        "normals are neither floats nor signed integers of 8 or 16 bits; `attributes` none leaves "
        "them out");
  if (use == GltfUse::colors && !real && type != GltfType::uint8 && type != GltfType::uint16)
    fail(
        "colours are neither floats nor unsigned integers of 8 or 16 bits; `attributes` none "
        "leaves them "
        "out");
}

void GltfElements::fail(const std::string& what) const {
  throw Error(ErrorKind::bad_input, "'" + name_ + "': " + what);
}

void GltfElements::read(const GltfSlice& slice, Layout layout, std::uint64_t first,
                        std::size_t count, std::vector<double>& out) {
  const std::size_t size = size_of(layout.type);
  const std::size_t element = layout.components * size;
  const std::uint64_t stride = layout.stride == 0 ? element : layout.stride;
  out.clear();
  // Wide strides in smaller parts.
  const std::size_t part = std::max<std::size_t>(1, (std::size_t{1} << 18) / stride);
  for (std::size_t done = 0; done < count;) {
    const std::size_t now = std::min(part, count - done);
    const std::span<const std::byte> bytes = bytes_.read(
        slice.view, slice.offset + (first + done) * stride, (now - 1) * stride + element);
    for (std::size_t i = 0; i < now; ++i) {
      for (std::size_t k = 0; k < layout.components; ++k)
        out.push_back(
            component(bytes.data() + i * stride + k * size, layout.type, layout.normalized));
    }
    done += now;
  }
}

std::span<const double> GltfElements::next() {
  const std::size_t count = std::min<std::uint64_t>(at_once, accessor_.count - next_);
  if (count == 0) return {};
  if (accessor_.base) {
    const std::uint64_t stride = document_.views[accessor_.base->view].stride;
    read(*accessor_.base, {accessor_.type, accessor_.components, normalized_, stride}, next_, count,
         values_);
  } else {
    values_.assign(count * accessor_.components, 0.0);
  }
  if (accessor_.sparse) change();
  next_ += count;
  return values_;
}

void GltfElements::change() {
  const GltfSparse& sparse = *accessor_.sparse;
  const std::uint64_t end = next_ + values_.size() / accessor_.components;
  for (; changed_ < sparse.count; ++changed_) {
    if (changed_ >= changes_from_ + change_indices_.size()) {
      changes_from_ = changed_;
      const std::size_t count = std::min<std::uint64_t>(at_once, sparse.count - changed_);
      read(sparse.indices, {sparse.index_type, 1}, changed_, count, change_indices_);
      read(sparse.values, {accessor_.type, accessor_.components, normalized_}, changed_, count,
           change_values_);
    }
    const std::size_t at = changed_ - changes_from_;
    const auto index = static_cast<std::uint64_t>(change_indices_[at]);
    if (index >= end) {
      if (index >= accessor_.count) fail("a sparse index names no element");
      return;
    }
    if (index < next_) fail("sparse indices are not in ascending order");
    std::copy_n(
        change_values_.begin() + static_cast<std::ptrdiff_t>(at * accessor_.components),
        accessor_.components,
        values_.begin() + static_cast<std::ptrdiff_t>((index - next_) * accessor_.components));
  }
}

}  // namespace winnow
