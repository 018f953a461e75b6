#include "read/ply/values.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/ply/scalar.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>

namespace winnow {

std::string PlyValues::record() const {
  return std::string(record_) + " " + grouped(number_);
}

namespace {

class BinaryValues final : public PlyValues {
 public:
  BinaryValues(ByteSource& source, bool swapped) : source_(source), swapped_(swapped) {}

  double real(PlyType type) override { return load_real(next(size_of(type)), type, swapped_); }
  std::int64_t integer(PlyType type) override {
    return load_integer(next(size_of(type)), type, swapped_);
  }

  void skip(PlyType type, std::uint64_t count) override {
    for (std::uint64_t left = count * size_of(type); left > 0;) {
      const std::size_t part = std::min<std::uint64_t>(left, block_size);
      next(part);
      left -= part;
    }
  }

  void sync() override {
    source_.give_back(block_.bytes.size() - at_);
    block_ = {};
    at_ = 0;
  }

 private:
  static constexpr std::size_t block_size = std::size_t{1} << 16;

  const std::byte* next(std::size_t bytes) {
    if (block_.bytes.size() - at_ < bytes) {
      block_.check_intact(source_.name());
      source_.give_back(block_.bytes.size() - at_);
      block_ = source_.take(std::max(bytes, block_size));
      at_ = 0;
      if (block_.bytes.size() < bytes) {
        throw Error(ErrorKind::bad_input, "'" + source_.name() + "' ends at byte " +
                                              grouped(source_.position()) + ", inside " + record() +
                                              ": it was cut short, or its header is wrong");
      }
    }
    at_ += bytes;
    return block_.bytes.data() + at_ - bytes;
  }

  ByteSource& source_;
  bool swapped_;
  Block block_;
  std::size_t at_ = 0;
};

class AsciiValues final : public PlyValues {
 public:
  explicit AsciiValues(ByteSource& source) : source_(source), tokens_(source) {
    // Lines are counted from the file's beginning; the header's are not known here any more.
    const std::uint64_t here = source.position();
    if (!source.seekable()) return;
    source.seek(0);
    const Block header = source.take(here);
    tokens_.start_line(1 + static_cast<std::uint64_t>(std::count(
                               header.bytes.begin(), header.bytes.end(), std::byte{'\n'})));
  }

  double real(PlyType type) override {
    const std::string_view word = next();
    const std::optional<double> value = parse_real(word);
    if (!value) fail(word);
    // What a binary file with this header would hold.
    return type == PlyType::float32 ? double{static_cast<float>(*value)} : *value;
  }

  std::int64_t integer(PlyType /*type*/) override {
    const std::string_view word = next();
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value) fail(word);
    return *value;
  }

  void skip(PlyType /*type*/, std::uint64_t count) override {
    for (; count > 0; --count) next();
  }

  void sync() override { tokens_.sync(); }

 private:
  std::string_view next() {
    const std::string_view word = tokens_.next();
    if (word.empty()) {
      throw Error(ErrorKind::bad_input, "'" + source_.name() + "' ends at line " +
                                            grouped(tokens_.line()) + ", inside " + record() +
                                            ": it was cut short, or its header is wrong");
    }
    return word;
  }

  [[noreturn]] void fail(std::string_view word) const {
    throw Error(ErrorKind::bad_input, "'" + source_.name() + "', line " + grouped(tokens_.line()) +
                                          ", " + record() + ": " + not_a_number(word));
  }

  ByteSource& source_;
  TextTokens tokens_;
};

}  // namespace

void skip_property(PlyValues& values, const PlyProperty& property) {
  std::uint64_t count = 1;
  if (property.list)
    count =
        static_cast<std::uint64_t>(std::max<std::int64_t>(0, values.integer(property.count_type)));
  values.skip(property.type, count);
}

std::unique_ptr<PlyValues> make_ply_values(ByteSource& source, PlyForm form) {
  if (form == PlyForm::ascii) return std::make_unique<AsciiValues>(source);
  return std::make_unique<BinaryValues>(source, form == PlyForm::big_endian);
}

}  // namespace winnow
