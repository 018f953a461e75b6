// The values of PLY records one after the other, whatever form the file has.
#pragma once

#include "io/byte_source.hpp"
#include "read/ply/header.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace winnow {

// Reads ahead; sync() gives back what was not used. Throws Error(bad_input) at the end of the
// content and, in ASCII, at what is no number.
class PlyValues {
 public:
  virtual ~PlyValues() = default;
  virtual double real(PlyType type) = 0;
  virtual std::int64_t integer(PlyType type) = 0;
  virtual void skip(PlyType type, std::uint64_t count) = 0;
  virtual void sync() = 0;

  // What is being read, for messages: "face", 17.
  void now_reading(const char* record, std::uint64_t number) {
    record_ = record;
    number_ = number;
  }

 protected:
  [[nodiscard]] std::string record() const;

 private:
  const char* record_ = "record";
  std::uint64_t number_ = 0;
};

// Passes over the value, or the list, of a property.
void skip_property(PlyValues& values, const PlyProperty& property);

std::unique_ptr<PlyValues> make_ply_values(ByteSource& source, PlyForm form);

}  // namespace winnow
