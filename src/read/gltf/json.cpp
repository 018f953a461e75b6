#include "read/gltf/json.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <cmath>

namespace winnow {

GltfJson::GltfJson(std::string_view text, const std::string& name) : name_(name) {
  try {
    root_ = Value::parse(text);
  } catch (const Value::exception& error) {
    fail("its JSON is damaged: " + one_line(error.what()));
  }
  if (!root_.is_object()) fail("its JSON is no object");
}

void GltfJson::fail(const std::string& what) const {
  throw Error(ErrorKind::bad_input, "'" + name_ + "': " + what);
}

std::string GltfJson::one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text.substr(0, 160);
}

const GltfJson::Value& GltfJson::find(const Value& object, const char* key) {
  static const Value none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

const GltfJson::Value& GltfJson::list(const Value& object, const char* key) const {
  const Value& value = find(object, key);
  if (!value.is_null() && !value.is_array()) fail("'" + std::string(key) + "' is no list");
  return value;
}

const GltfJson::Value& GltfJson::member(const Value& object, const char* key) const {
  const Value& value = find(object, key);
  if (!value.is_null() && !value.is_object()) fail("'" + std::string(key) + "' is no object");
  return value;
}

std::string GltfJson::text(const Value& object, const char* key) {
  const Value& value = find(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::uint64_t GltfJson::count(const Value& value, const char* what) const {
  constexpr double most = 9.0e15;
  if (value.is_number_unsigned() &&
      value.get<std::uint64_t>() <= std::uint64_t{9'000'000'000'000'000})
    return value.get<std::uint64_t>();
  if (value.is_number_float() && value.get<double>() >= 0 && value.get<double>() <= most &&
      value.get<double>() == std::floor(value.get<double>())) {
    return static_cast<std::uint64_t>(value.get<double>());
  }
  fail("'" + std::string(what) + "' is no count or index");
}

std::uint64_t GltfJson::count(const Value& object, const char* key, std::uint64_t usual) const {
  const Value& value = find(object, key);
  return value.is_null() ? usual : count(value, key);
}

std::uint64_t GltfJson::required(const Value& object, const char* key) const {
  const Value& value = find(object, key);
  if (value.is_null()) fail("'" + std::string(key) + "' is missing");
  return count(value, key);
}

std::size_t GltfJson::index_into(const Value& value, const char* key, std::size_t size) const {
  const std::uint64_t index = count(value, key);
  if (index >= size)
    fail("'" + std::string(key) + "' names number " + std::to_string(index) + " of " +
         std::to_string(size));
  return index;
}

std::size_t GltfJson::required_index(const Value& object, const char* key, std::size_t size) const {
  const Value& value = find(object, key);
  if (value.is_null()) fail("'" + std::string(key) + "' is missing");
  return index_into(value, key, size);
}

void GltfJson::check_object(const Value& value, const char* what) const {
  if (!value.is_object()) fail(std::string("one of its ") + what + " is no object");
}

}  // namespace winnow
