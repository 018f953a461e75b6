// A manifest comes back as it was, or is noticed to have been changed.
#include "io/manifest.hpp"

#include "support/job.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("values of a manifest come back") {
  Manifest manifest;
  manifest.set("path", std::string("/a b/line\nend\\n \\"));
  manifest.set("empty", std::string());
  manifest.set("count", std::uint64_t{UINT64_MAX});
  manifest.set("third", 1.0 / 3);
  manifest.set("least", std::numeric_limits<double>::denorm_min());
  manifest.set("all", std::numeric_limits<double>::infinity());
  const Manifest again = Manifest::parse(manifest.print(), "file");
  CHECK(again.text("path") == "/a b/line\nend\\n \\");
  CHECK(again.text("empty").empty());
  CHECK(again.number("count") == UINT64_MAX);
  CHECK(again.real("third") == 1.0 / 3);
  CHECK(again.real("least") == std::numeric_limits<double>::denorm_min());
  CHECK(again.real("all") == std::numeric_limits<double>::infinity());
  CHECK(again.print() == manifest.print());
  CHECK_FALSE(again.has("other"));
  CHECK(test::error_of([&] { (void)again.number("path"); }).kind() == ErrorKind::bad_input);
  CHECK(test::error_of([&] { (void)again.text("other"); }).kind() == ErrorKind::bad_input);
}

TEST_CASE("any changed or missing byte of a manifest is noticed") {
  Manifest manifest;
  manifest.set("one", std::uint64_t{1});
  manifest.set("two", std::string("2"));
  const std::string text = manifest.print();
  for (std::size_t i = 0; i < text.size(); ++i) {
    CAPTURE(i);
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    for (const std::string& bad : {changed, text.substr(0, i), text + text.substr(i)}) {
      const Error error = test::error_of([&] { Manifest::parse(bad, "here/manifest"); });
      CHECK(error.kind() == ErrorKind::bad_input);
      CHECK(std::string(error.what()).find("'here/manifest'") != std::string::npos);
    }
  }
}

}  // namespace winnow
