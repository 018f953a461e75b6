// Values by name, as lines of text that notice when one was changed.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace winnow {

class Manifest {
 public:
  void set(const std::string& key, const std::string& text) { values_[key] = text; }
  void set(const std::string& key, std::uint64_t number) { values_[key] = std::to_string(number); }
  void set(const std::string& key, double number);  // comes back as the same double
  void erase(const std::string& key) { values_.erase(key); }

  [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) != 0; }
  // Throw Error(bad_input) where the value is missing or no number.
  [[nodiscard]] const std::string& text(const std::string& key) const;
  [[nodiscard]] std::uint64_t number(const std::string& key) const;
  [[nodiscard]] double real(const std::string& key) const;

  // A line each, then one with the checksum of all before it.
  [[nodiscard]] std::string print() const;
  // `path` is for messages. Throws Error(bad_input) for anything that print() did not write.
  static Manifest parse(const std::string& text, const std::string& path);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::map<std::string, std::string> values_;
};

// What is told about a checkpoint whose file cannot be used: which, and the way out.
[[noreturn]] void damaged_checkpoint(const std::string& path, const std::string& what);

}  // namespace winnow
