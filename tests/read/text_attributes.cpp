// What the first lines of OBJ and OFF say that their vertices carry.
#include "read/formats.hpp"
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

std::string line_of(const AvailableAttributes& offer) {
  std::string line;
  for (const Attribute& attribute : offer.scalars)
    line += (line.empty() ? "" : " ") + attribute.name + ":" + name_of(attribute.type);
  return line;
}

AvailableAttributes offer_of(const InputFormat& format, const std::string& head) {
  TestJob here;
  MemorySource source(head);
  InputProbe probe;
  format.probe(here.job, source, false, probe);
  return probe.facts.offer;
}

std::vector<double> carried_by(const std::string& content, MemorySource::Kind kind) {
  return test::carried_by(std::make_unique<MemorySource>(content, kind)).numbers;
}

}  // namespace

TEST_CASE("an OBJ offers the colours that its first vertex has") {
  CHECK(line_of(offer_of(obj_input, "# v 1 2 3 4 5 6\nmtllib a\nv 0 0 0 .5 1 0\nv 0 0 0\n")) ==
        "red:float green:float blue:float");
  CHECK(line_of(offer_of(obj_input, "v 0 0 0\nv 0 0 0 .5 1 0\n")).empty());
  CHECK(line_of(offer_of(obj_input, "v 0 0 0 1\n")).empty());
  CHECK(line_of(offer_of(obj_input, "vn 0 0 0 1 1 1\n")).empty());
  CHECK(line_of(offer_of(obj_input, "")).empty());
}

TEST_CASE("an OFF offers what its keyword says and its vertices have") {
  const struct {
    const char* head;
    const char* offer;
  } cases[] = {{"OFF\n1 0 0\n0 0 0 1 1 1\n", ""},
               {"NOFF\n1 0 0\n0 0 0 1 1 1\n", "nx:float ny:float nz:float"},
               {"NOFF\n1 0 0\n0 0 0\n", ""},
               {"COFF\n2 0 0\n0 0 0 0 1 0\n0 0 0 255 0 0\n", "red:uchar green:uchar blue:uchar"},
               {"COFF\n2 0 0\n0 0 0 0 1 0 1\n0 0 0 1 0 0 1\n",
                "red:float green:float blue:float alpha:float"},
               {"COFF 2 0 0\n0 0 0 7 1 0 1\n# so\n0 0 0 1 0 0.5 1\n",
                "red:float green:float blue:float alpha:float"},
               {"COFF 1 1\n0 0 0 7 8 9\n3 0 1 2 0.5\n", "red:uchar green:uchar blue:uchar"},
               {"COFF\n1 0 0\n0 0 0 3\n", ""},
               {"STCNOFF\n1 0 0\n0 0 0 1 0 0 9 9 9 0.5 0.5\n",
                "nx:float ny:float nz:float red:uchar green:uchar blue:uchar s:float t:float"},
               {"STOFF\n1 0 0\n0 0 0 1 1\n", "s:float t:float"},
               {"COFF\n", ""},
               {"", ""}};
  for (const auto& one : cases) {
    CAPTURE(one.head);
    CHECK(line_of(offer_of(off_input, one.head)) == one.offer);
  }
}

TEST_CASE("colours of an OBJ and of an OFF arrive with their vertices") {
  for (const auto kind : {MemorySource::Kind::file, MemorySource::Kind::pipe}) {
    const std::vector<double> obj =
        carried_by("v 0 0 0 0.25 1 0\nv 1 0 0 0.75 1 0\nv 0 1 0 0.5 0 1 # last\nf 1 2 3\n", kind);
    REQUIRE(obj.size() == 9);
    CHECK(obj[0] == 0.25);
    CHECK(obj[1] == 0.75);
    CHECK(obj[2] == 0.5);
    CHECK(obj[8] == 1);
    CHECK(carried_by(
              "CNOFF 3 1 0\n0 0 0 1 0 0 9 8 7\n1 0 0 0 1 0 6 5 4\n0 1 0 0 0 1 3 2 255\n3 0 1 2\n",
              kind) == std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1, 9, 6, 3, 8, 5, 2, 7, 4, 255});
  }
}

TEST_CASE("a vertex of an OFF that lacks its colour is an error where colours are carried") {
  const Error error = error_of([] {
    carried_by("COFF 3 1 0\n0 0 0 1 0 2\n1 0 0 1 1\n0 1 0 2 3 4\n3 0 1 2\n",
               MemorySource::Kind::file);
  });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(std::string(error.what()).find("line 3") != std::string::npos);
}

}  // namespace winnow::test
