// The values of a glTF's JSON, each taken for what it should be or refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace winnow {

// All members throw Error(bad_input), beginning with the name, where a value is of another kind.
class GltfJson {
 public:
  using Value = nlohmann::json;

  // `name` of the file must live as long as this.
  GltfJson(std::string_view text, const std::string& name);

  [[nodiscard]] const Value& root() const { return root_; }
  [[noreturn]] void fail(const std::string& what) const;
  // Messages are one line, and end.
  static std::string one_line(std::string text);

  // Null where there is none.
  static const Value& find(const Value& object, const char* key);
  // What is not there is empty.
  [[nodiscard]] const Value& list(const char* key) const { return list(root_, key); }
  [[nodiscard]] const Value& list(const Value& object, const char* key) const;
  [[nodiscard]] const Value& member(const Value& object, const char* key) const;
  static std::string text(const Value& object, const char* key);

  // Counts, sizes and offsets.
  [[nodiscard]] std::uint64_t count(const Value& object, const char* key,
                                    std::uint64_t usual) const;
  [[nodiscard]] std::uint64_t required(const Value& object, const char* key) const;
  // The number of one of `size` things.
  [[nodiscard]] std::size_t index_into(const Value& value, const char* key, std::size_t size) const;
  [[nodiscard]] std::size_t required_index(const Value& object, const char* key,
                                           std::size_t size) const;

  void check_object(const Value& value, const char* what) const;

  template <std::size_t Size>
  [[nodiscard]] std::optional<std::array<double, Size>> numbers(const Value& object,
                                                                const char* key) const {
    const Value& values = list(object, key);
    if (values.is_null()) return {};
    std::array<double, Size> result{};
    if (values.size() != Size) fail("'" + std::string(key) + "' has the wrong number of values");
    for (std::size_t i = 0; i < Size; ++i) {
      if (!values[i].is_number()) fail("'" + std::string(key) + "' holds what is no number");
      result[i] = values[i].template get<double>();
    }
    return result;
  }

 private:
  [[nodiscard]] std::uint64_t count(const Value& value, const char* what) const;

  const std::string& name_;
  Value root_;
};

}  // namespace winnow
