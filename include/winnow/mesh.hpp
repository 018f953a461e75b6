// Simplify a mesh in memory: arrays in, arrays out.
#pragma once

#include <winnow/api.hpp>
#include <winnow/context.hpp>
#include <winnow/number_type.hpp>
#include <winnow/simplify.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace winnow {

// Any whole number of 8 to 64 bits, float or double.
template <typename T>
concept Number = (std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, char>) ||
                 std::same_as<T, float> || std::same_as<T, double>;

template <Number T>
constexpr NumberType type_of_number() {
  if constexpr (std::floating_point<T>) {
    return sizeof(T) == sizeof(float) ? NumberType::float32 : NumberType::float64;
  } else {
    constexpr bool wide = sizeof(T) > 2;
    constexpr auto smallest = wide ? (sizeof(T) == 4 ? NumberType::int32 : NumberType::int64)
                                   : (sizeof(T) == 1 ? NumberType::int8 : NumberType::int16);
    return static_cast<NumberType>(static_cast<std::uint8_t>(smallest) + std::is_unsigned_v<T>);
  }
}

// Rows of so many numbers of one type, in memory that is the caller's and stays as it is during a
// call. Nothing but these numbers is read.
template <std::size_t Width>
class Rows {
 public:
  Rows() = default;

  // Numbers side by side: x y z x y z ..., in a vector, an array or a span that outlives this.
  template <std::ranges::contiguous_range Numbers>
  requires std::ranges::borrowed_range<Numbers> && std::ranges::sized_range<Numbers> &&
      Number<std::ranges::range_value_t<Numbers>>
      Rows(Numbers&& numbers)
      : Rows(std::ranges::data(numbers), std::ranges::size(numbers) / Width,
             Width * sizeof(std::ranges::range_value_t<Numbers>)) {
    left_over_ = std::ranges::size(numbers) % Width;
  }

  // The same, of std::arrays.
  template <std::ranges::contiguous_range Arrays>
  requires std::ranges::borrowed_range<Arrays> && std::ranges::sized_range<Arrays> &&
      Number<typename std::ranges::range_value_t<Arrays>::value_type> &&
      std::same_as<std::ranges::range_value_t<Arrays>,
                   std::array<typename std::ranges::range_value_t<Arrays>::value_type, Width>>
      Rows(Arrays&& rows)
      : Rows(reinterpret_cast<const typename std::ranges::range_value_t<Arrays>::value_type*>(
                 std::ranges::data(rows)),
             std::ranges::size(rows), sizeof(std::ranges::range_value_t<Arrays>)) {}

  // Rows that stand apart, as members of a struct do: `stride` bytes from the first number of one
  // to the first number of the next.
  template <Number T>
  Rows(const T* first, std::uint64_t count, std::size_t stride)
      : data_(first), type_(type_of_number<T>()), count_(count), stride_(stride) {}

  [[nodiscard]] const void* data() const { return data_; }
  [[nodiscard]] NumberType type() const { return type_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }        // bytes
  [[nodiscard]] std::size_t left_over() const { return left_over_; }  // numbers behind the last row

 private:
  const void* data_ = nullptr;
  NumberType type_ = NumberType::float32;
  std::uint64_t count_ = 0;
  std::size_t stride_ = 0;
  std::size_t left_over_ = 0;
};

// A mesh in arrays of the caller.
struct MeshView {
  Rows<3> positions;  // floats or doubles; at most 2^32 - 1 vertices
  Rows<3> faces;      // numbers of vertices, from 0; 32 or 64 bits, signed or not

  // One number a vertex, of a type of up to 32 bits or double. Names mean what they mean in a PLY:
  // nx, ny and nz are a normal, red, green and blue a colour; see SimplifyOptions::attributes.
  struct Attribute {
    std::string name;
    Rows<1> values;
  };
  std::vector<Attribute> attributes{};
};

// A mesh that owns its arrays.
struct Mesh {
  std::variant<std::vector<float>, std::vector<double>> positions;  // x y z x y z ...
  std::vector<std::uint32_t> faces;  // three numbers of vertices each; no result has 2^32 vertices

  struct Attribute {
    std::string name;
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<float>, std::vector<double>>
        values;
  };
  std::vector<Attribute> attributes;

  [[nodiscard]] WINNOW_API std::uint64_t vertex_count() const;
  [[nodiscard]] std::uint64_t face_count() const { return faces.size() / 3; }
  [[nodiscard]] WINNOW_API MeshView view() const;  // good for as long as the mesh stays as it is
};

// The vertices, faces and attributes that simplify() writes for a binary PLY of the same content,
// in the same order. Normals of SimplifyOptions::normals are attributes nx, ny and nz.
//
// Neither the arrays that come in nor those that go out count in the budget. Positions are looked
// up where they are, and so are attributes whose rows stand as far apart as the positions;
// otherwise what is carried is copied, within the budget. Of the options `from` and `force` have no
// meaning; what chooses a format or compresses it is a usage error.
//
// A face with an index of no vertex, or with a corner that is not finite, is a bad one, as in a
// file: it is counted and left out, and with `strict` it is an error. `report` and `map`: where
// they go, if anywhere; the map does not count in the budget.
//
// Throws Error: usage (options; arrays of other types, or that share memory in a wrong way),
// bad_input (sizes that do not fit, nothing to simplify), resources, cancelled, failed. The message
// names the array: positions, faces or attributes.
WINNOW_API Mesh simplify(Context& context, const MeshView& mesh, const SimplifyOptions& options,
                         SimplifyReport* report = nullptr, VertexMap* map = nullptr);

// The same for several targets (SimplifyOptions::coarser) in one run: the finest mesh first. `maps`
// becomes one map a mesh.
WINNOW_API std::vector<Mesh> simplify_levels(Context& context, const MeshView& mesh,
                                             const SimplifyOptions& options,
                                             SimplifyReport* report = nullptr,
                                             std::vector<VertexMap>* maps = nullptr);
WINNOW_API std::vector<Mesh> simplify_levels(Context& context, const std::string& input,
                                             const SimplifyOptions& options,
                                             SimplifyReport* report = nullptr,
                                             std::vector<VertexMap>* maps = nullptr);

// From memory to a file, and from a file to memory.
WINNOW_API SimplifyReport simplify(Context& context, const MeshView& mesh,
                                   const std::string& output, const SimplifyOptions& options);
WINNOW_API Mesh simplify(Context& context, const std::string& input, const SimplifyOptions& options,
                         SimplifyReport* report = nullptr, VertexMap* map = nullptr);

}  // namespace winnow
