// Looking through gzip and zstd: all of the content, or an error; never a part of it in silence.
#include "base/process.hpp"
#include "io/byte_source.hpp"
#include "support/files.hpp"
#include "support/job.hpp"
#include "support/random.hpp"
#include "support/sanitized.hpp"
#include "support/sources.hpp"

#include <algorithm>
#include <cctype>

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <catch2/catch.hpp>
#include <zstd.h>

namespace winnow {

namespace {

namespace bio = boost::iostreams;

std::string gzip(const std::string& plain) {
  std::string packed;
  bio::filtering_istreambuf in;
  in.push(bio::gzip_compressor());
  in.push(bio::array_source(plain.data(), plain.size()));
  bio::copy(in, bio::back_inserter(packed));
  return packed;
}

struct ZstdStyle {
  bool checksum = true;
  bool size_in_header = true;
  int window_log = 0;  // the library's choice
};

std::string zstd(const std::string& plain, const ZstdStyle& style = {}) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, style.checksum ? 1 : 0);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_contentSizeFlag, style.size_in_header ? 1 : 0);
  if (style.window_log != 0)
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog, style.window_log);
  std::string packed(ZSTD_compressBound(plain.size()) + 100, '\0');
  ZSTD_inBuffer in{plain.data(), plain.size(), 0};
  ZSTD_outBuffer out{packed.data(), packed.size(), 0};
  if (!style.size_in_header) {  // as a program at the end of a pipe does, that does not know how
                                // much comes
    for (std::size_t at = 0; at < plain.size();) {
      in.size = std::min(plain.size(), at + 10'000);
      ZSTD_compressStream2(context.get(), &out, &in, ZSTD_e_continue);
      at = in.pos;
    }
  }
  REQUIRE(ZSTD_compressStream2(context.get(), &out, &in, ZSTD_e_end) == 0);
  packed.resize(out.pos);
  return packed;
}

std::string skippable_frame(std::size_t length) {
  std::string frame("\x50\x2a\x4d\x18", 4);
  for (unsigned i = 0; i < 4; ++i) frame += static_cast<char>(length >> (8 * i));
  return frame + std::string(length, 'x');
}

class Unpacker {
 public:
  // In takes of this size.
  std::string operator()(const std::string& packed, std::size_t part = 100'000) const {
    test::write_file(directory_.file("packed"), packed);
    test::TestJob test;
    const auto source = open_source(test.job, directory_.file("packed"));
    std::string plain;
    for (Block block = source->take(part); !block.bytes.empty(); block = source->take(part))
      plain += test::text_of(block.bytes);
    return plain;
  }

 private:
  test::Directory directory_;
};

// What compresses well comes out of the decoder in pieces larger than those that are asked for.
std::string regular(std::size_t size) {
  std::string text;
  for (std::size_t i = 0; text.size() < size; ++i)
    text += "vertex " + std::to_string(i % 1000) + '\n';
  text.resize(size);
  return text;
}

// At every place of a small content and some of a large one: an Error, or, between two parts, the
// whole parts.
void check_cuts(const std::string& packed, const std::vector<std::size_t>& part_ends,
                const std::vector<std::string>& parts) {
  const Unpacker unpack;
  const std::size_t step = std::max<std::size_t>(1, packed.size() / 700);
  for (std::size_t length = 4; length < packed.size(); length += step) {
    CAPTURE(length);
    const auto whole = std::find(part_ends.begin(), part_ends.end(), length);
    if (whole == part_ends.end()) {
      const Error error = test::error_of([&] { unpack(packed.substr(0, length)); });
      REQUIRE(error.kind() == ErrorKind::bad_input);
    } else {
      std::string plain;
      for (std::size_t i = 0; i <= static_cast<std::size_t>(whole - part_ends.begin()); ++i)
        plain += parts[i];
      REQUIRE(unpack(packed.substr(0, length)) == plain);
    }
  }
}

}  // namespace

TEST_CASE("several gzip members are one content") {
  test::Random random(90);
  const Unpacker unpack;
  for (const std::size_t size : {std::size_t{1}, std::size_t{2000}, std::size_t{300'000}}) {
    std::string packed;
    std::string plain;
    for (int member = 0; member < 4; ++member) {
      const std::string part =
          member == 2 ? "" : random.bytes(random.between(1, size)) + regular(size);
      packed += gzip(part);
      plain += part;
    }
    for (const std::size_t take : {std::size_t{1000}, std::size_t{1} << 22}) {
      CAPTURE(size, take);
      CHECK(unpack(packed, take) == plain);
    }
  }
}

TEST_CASE("several zstd frames are one content, with skippable ones between") {
  test::Random random(91);
  const Unpacker unpack;
  for (const std::size_t size : {std::size_t{1}, std::size_t{2000}, std::size_t{300'000}}) {
    std::string packed;
    std::string plain;
    for (int frame = 0; frame < 5; ++frame) {
      const std::string part =
          frame == 2 ? "" : random.bytes(random.between(1, size)) + regular(size);
      packed += zstd(part, {frame % 2 == 0, frame % 3 == 0, 0});
      if (frame % 2 == 0) packed += skippable_frame(random.between(0, 500));
      plain += part;
    }
    for (const std::size_t take : {std::size_t{1000}, std::size_t{1} << 22}) {
      CAPTURE(size, take);
      CHECK(unpack(packed, take) == plain);
    }
  }
}

TEST_CASE("a zstd content ends where it ends, whatever the decoder still holds") {
  // Reads end inside of what one step of the decoder makes, with no bytes of the file left.
  const Unpacker unpack;
  for (const bool checksum : {true, false}) {
    for (const std::size_t over : {1, 1000, 50'000, 131'071, 131'072, 131'073, 500'000}) {
      for (const std::size_t take :
           {std::size_t{70'001}, std::size_t{1} << 20, std::size_t{3} << 20}) {
        const std::string plain = regular((std::size_t{1} << 20) + over);
        CAPTURE(checksum, over, take);
        CHECK(unpack(zstd(plain, {checksum, true, 0}), take) == plain);
      }
    }
  }
}

TEST_CASE("a gzip content that was cut is an error") {
  test::Random random(92);
  const std::vector<std::string> small{random.bytes(300), regular(500)};
  const std::string first = gzip(small[0]);
  const std::string both = first + gzip(small[1]);
  check_cuts(both, {first.size()}, small);
  const std::vector<std::string> large{random.bytes(200'000) + regular(300'000)};
  check_cuts(gzip(large[0]), {}, large);
}

TEST_CASE("a zstd content that was cut is an error") {
  test::Random random(93);
  const std::vector<std::string> small{random.bytes(300), regular(500)};
  for (const bool checksum : {true, false}) {
    const std::string first = zstd(small[0], {checksum, true, 0});
    const std::string both = first + zstd(small[1], {checksum, false, 0});
    check_cuts(both, {first.size()}, small);
    const std::vector<std::string> large{random.bytes(200'000) + regular(300'000)};
    check_cuts(zstd(large[0], {checksum, true, 0}), {}, large);
  }
}

TEST_CASE("what follows a gzip content is ignored, zeros in silence") {
  test::Random random(95);
  const test::Directory directory;
  const std::string plain = regular(3000);
  const auto notes_of = [&](const std::string& behind) {
    test::write_file(directory.file("packed"), gzip(plain) + gzip(plain) + behind);
    test::TestJob test;
    const auto source = open_source(test.job, directory.file("packed"));
    CHECK(test::text_of(source->take(100'000).bytes) == plain + plain);
    CHECK(source->take(1).bytes.empty());
    return test.job.notes.size();
  };
  for (const std::size_t length : {1, 2, 500, 10'000, 1'000'000}) {
    CAPTURE(length);
    CHECK(notes_of(std::string(length, '\0')) == 0);
    CHECK(notes_of(std::string(length, 'x')) == 1);
    CHECK(notes_of(std::string(length, '\0') + "x") == 1);
  }
  CHECK(notes_of(std::string(3, '\0') + gzip(plain)) == 1);
}

TEST_CASE("a gzip header of any length takes no memory") {
  const std::string plain = regular(3000);
  std::string packed = gzip(plain);
  packed[3] = 0x18;  // a name and a comment follow
  packed.insert(10, std::string(200'000'000, 'n') + '\0' + std::string(1'000'000, 'c') + '\0');
  const test::Directory directory;
  test::write_file(directory.file("packed"), packed);
  test::TestJob test;
  const std::uint64_t before = peak_resident_bytes();
  CHECK(test::text_of(open_source(test.job, directory.file("packed"))->take(100'000).bytes) ==
        plain);
  if (!test::sanitized) CHECK(peak_resident_bytes() - before < std::uint64_t{16} << 20);
}

TEST_CASE("a zstd content may begin with frames that are skipped") {
  const Unpacker unpack;
  const std::string plain = regular(300'000);
  for (char number = 0x50; number < 0x60; ++number) {
    std::string frame = skippable_frame(4);
    frame[0] = number;
    CHECK(unpack(frame + zstd(plain)) == plain);
  }
  CHECK(unpack(skippable_frame(1'000'000) + skippable_frame(0) + zstd(plain)) == plain);
}

TEST_CASE("the place where a compressed content breaks is told, in the file and in the content") {
  test::Random random(96);
  const Unpacker unpack;
  const auto numbers_of = [](const std::string& message) {
    std::vector<std::size_t> numbers;
    for (std::size_t at = message.find(" at byte "); at != std::string::npos;
         at = message.find_first_of("0123456789", at)) {
      at = message.find_first_of("0123456789", at);
      std::string digits;
      for (; std::isdigit(message[at]) != 0 || message[at] == ','; ++at) {
        if (message[at] != ',') digits += message[at];
      }
      numbers.push_back(std::stoul(digits));
    }
    return numbers;
  };
  // As random as this, the packed content is as long in every part.
  const std::string plain = random.bytes(5'000'000);
  constexpr std::size_t block = 128 * 1024;
  for (const std::string& whole : {gzip(plain), zstd(plain)}) {
    for (const std::size_t place :
         {std::size_t{700'000}, std::size_t{2'500'000}, whole.size() - 9}) {
      CAPTURE(whole.size(), place);
      const Error cut = test::error_of([&] { unpack(whole.substr(0, place)); });
      CAPTURE(cut.what());
      const std::vector<std::size_t> ends = numbers_of(cut.what());
      REQUIRE(ends.size() == 2);
      CHECK(ends[0] == place);
      const std::size_t even = plain.size() / 1000 * place / (whole.size() / 1000);
      CHECK(ends[1] + block + even / 100 >= even);
      CHECK(ends[1] <= even + even / 100);
    }
    std::string damaged = whole;
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    const std::vector<std::size_t> last =
        numbers_of(test::error_of([&] { unpack(damaged); }).what());
    REQUIRE(last.size() == 2);
    CHECK(last[0] + 16 >= whole.size());
    CHECK(last[1] == plain.size());
  }
}

TEST_CASE("a changed byte of a compressed content is an error or changes nothing") {
  test::Random random(94);
  const Unpacker unpack;
  const std::string plain = random.bytes(3000) + regular(3000);
  for (const std::string& packed : {gzip(plain), zstd(plain)}) {
    int errors = 0;
    for (int i = 0; i < 300; ++i) {
      std::string damaged = packed;
      const std::size_t at = random.between(4, packed.size() - 1);
      damaged[at] = static_cast<char>(damaged[at] ^ 1 << random.below(8));
      CAPTURE(at);
      try {
        const std::string got = unpack(damaged);
        REQUIRE(got == plain);  // a bit of the header that nobody reads, as gzip's time
      } catch (const Error& error) {
        REQUIRE((error.kind() == ErrorKind::bad_input || error.kind() == ErrorKind::resources));
        ++errors;
      }
    }
    CHECK(errors > 280);
  }
}

TEST_CASE("a zstd window that the budget does not hold is refused, not taken") {
  const test::Directory directory;
  const std::string plain = regular(20'000'000);
  test::write_file(directory.file("long.zst"), zstd(plain, {true, false, 24}));
  for (const bool enough : {true, false}) {
    test::TestJob test({.memory = std::uint64_t{enough ? 20U : 15U} << 20});
    const auto source = open_source(test.job, directory.file("long.zst"));
    CAPTURE(enough);
    if (enough) {
      CHECK(source->take(1000).bytes.size() == 1000);
      CHECK(test.job.budget.used() >= std::uint64_t{16} << 20);
    } else {
      CHECK(test::error_of([&] { source->take(1000); }).kind() == ErrorKind::resources);
    }
  }
}

}  // namespace winnow
