// ASCII STL as programs write it.
#include "support/job.hpp"
#include "support/reading.hpp"
#include "support/sources.hpp"
#include "support/stl_file.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using test::difference;

namespace {

void check_same(const std::string& file, const std::vector<test::Triangle>& faces) {
  CAPTURE(file.substr(0, 400));
  CHECK(difference(test::faces_of(file), test::as_seen(faces)) == "");
  CHECK(difference(test::faces_of_pipe(file), test::as_seen(faces)) == "");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

const std::vector<test::Triangle>& some_faces() {
  static const std::vector<test::Triangle> faces = [] {
    test::Random random(280);
    return test::random_triangles(random, 40);
  }();
  return faces;
}

}  // namespace

TEST_CASE("an ASCII STL is read as it was written") {
  test::Random random(281);
  for (const std::size_t count : {1, 2, 511, 512, 513, 9000}) {
    const std::vector<test::Triangle> faces = test::random_triangles(random, count);
    check_same(test::ascii_stl(faces), faces);
  }
}

TEST_CASE("both forms of an STL hold the same faces") {
  test::Random random(282);
  // Digits beyond a float's are rounded as the binary form would have.
  std::string file = "solid x\n";
  std::vector<test::Triangle> faces(200);
  for (test::Triangle& face : faces) {
    file += "facet normal 0 0 0\nouter loop\n";
    for (test::Point& p : face) {
      file += "vertex";
      for (double& x : p) {
        x = random.real(-1e6, 1e6);
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), " %.15e", x);
        file += text.data();
        x = static_cast<float>(x);
      }
      file += "\n";
    }
    file += "endloop\nendfacet\n";
  }
  check_same(file + "endsolid x\n", faces);
  CHECK(difference(test::faces_of(test::binary_stl(faces)), test::as_seen(faces)) == "");
}

TEST_CASE("case, blanks and the end of the file do not matter") {
  for (const bool upper : {false, true}) {
    for (const std::string indent : {"", "  ", "\t", "\n  \t"}) {
      for (const bool end : {false, true}) {
        test::AsciiStlStyle style{"thing", "\n", indent, upper, end};
        check_same(test::ascii_stl(some_faces(), style), some_faces());
        std::string no_last_newline = test::ascii_stl(some_faces(), style);
        no_last_newline.pop_back();
        check_same(no_last_newline, some_faces());
      }
    }
  }
  check_same("\n  \n" + test::ascii_stl(some_faces()), some_faces());
  check_same(replaced(test::ascii_stl(some_faces()), "outer loop", "OuTeR  \t LoOp"), some_faces());
}

TEST_CASE("lines may end as on any system") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    CAPTURE(end.size(), end[0] == '\r');
    check_same(test::ascii_stl(some_faces(), {.line_end = end}), some_faces());
  }
}

TEST_CASE("the name of a solid may hold any words") {
  for (const std::string& name :
       {std::string(), std::string("facet"), std::string("solid"),
        std::string("facet normal 0 0 1"), std::string("endsolid endfacet vertex 1 2 3"),
        std::string("caf\xc3\xa9 \xe2\x84\x96 1"), std::string(3000, 'n'),
        std::string(90'000, 'm') + " facet", std::string("binary")}) {
    if (name.size() > 65536 && name.find(' ') != std::string::npos) {
      // A name longer than a block, in words of a length that a text may have.
      check_same(
          test::ascii_stl(some_faces(), {.name = replaced(name, "mmmmmmmmmm", "mmmmmmmmm ")}),
          some_faces());
      continue;
    }
    check_same(test::ascii_stl(some_faces(), {.name = name}), some_faces());
  }
}

TEST_CASE("a solid without its last line is read, and told") {
  for (const bool end : {true, false}) {
    test::TestJob test;
    const std::string file = test::ascii_stl(some_faces(), {.end = end});
    const auto reader =
        open_reader(test.job, std::make_unique<test::MemorySource>(file), Format::automatic,
                    Access::once, {test::usual_vertex_memory, 8});
    CHECK(difference(test::read_faces(test.job, *reader), test::as_seen(some_faces())) == "");
    CHECK(difference(test::read_faces(test.job, *reader), test::as_seen(some_faces())) == "");
    CHECK(test.job.notes.size() == (end ? 0 : 1));
  }
}

TEST_CASE("several solids are one mesh") {
  test::Random random(283);
  std::string file;
  std::vector<test::Triangle> all;
  for (int i = 0; i < 5; ++i) {
    const std::vector<test::Triangle> faces =
        test::random_triangles(random, i == 2 ? 0 : random.between(1, 700));
    file += test::ascii_stl(faces, {.name = "facet " + std::to_string(i), .end = i % 2 == 0});
    all.insert(all.end(), faces.begin(), faces.end());
  }
  check_same(file, all);
}

TEST_CASE("a facet of more than three corners is a fan, one of fewer is degenerate") {
  const auto facet = [](const std::vector<std::string>& corners) {
    std::string text = "facet normal 0 0 1\nouter loop\n";
    for (const std::string& corner : corners) text += "vertex " + corner + "\n";
    return text + "endloop\nendfacet\n";
  };
  const std::string file = "solid s\n" + facet({"0 0 0", "1 0 0", "1 1 0", "0 1 0", "-1 1 0"}) +
                           facet({"0 0 5", "1 0 5"}) + facet({}) +
                           facet({"0 0 7", "1 0 7", "0 1 7"}) + "endsolid s\n";
  const std::vector<test::SeenFace> right{{FaceStatus::good, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}},
                                          {FaceStatus::good, {{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}},
                                          {FaceStatus::good, {{{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}}}},
                                          {FaceStatus::degenerate, {}},
                                          {FaceStatus::degenerate, {}},
                                          {FaceStatus::good, {{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}}}}};
  CHECK(difference(test::faces_of(file), right) == "");
  CHECK(difference(test::faces_of_pipe(file), right) == "");
}

TEST_CASE("a facet without corners adds no position to the box") {
  // Far from the origin: a corner at zero would make the box enormous, and the lattice begin
  // elsewhere.
  const std::string far =
      "facet normal 0 0 1\nouter loop\nvertex 5000000 100 1\nvertex 5000001 100 1\nvertex 5000000 "
      "101 "
      "1\nendloop\nendfacet\n";
  for (const std::string empty :
       {"facet normal 0 0 1\nouter loop\nendloop\nendfacet\n",
        "facet normal 0 0 1\nouter loop\nvertex 5000000 100 1\nendloop\nendfacet\n"}) {
    for (const std::string& file : {"solid s\n" + empty + far + "endsolid\n",
                                    "solid s\n" + far + empty + far + "endsolid\n"}) {
      for (const auto kind : {test::MemorySource::Kind::file, test::MemorySource::Kind::pipe}) {
        test::TestJob test;
        const auto reader =
            open_reader(test.job, std::make_unique<test::MemorySource>(file, kind),
                        Format::automatic, Access::once, {test::usual_vertex_memory, 256});
        const auto first = reader->first_finite_position();
        REQUIRE(first);
        CHECK((*first)[0] >= 5e6);
        if (kind == test::MemorySource::Kind::pipe) continue;
        for (const test::Point& p : test::read_positions(test.job, *reader)) {
          if (std::isfinite(p[0])) CHECK(p[0] >= 5e6);
        }
      }
    }
  }
}

TEST_CASE("one facet of very many corners does not fill the memory") {
  std::string file = "solid s\nfacet normal 0 0 1\nouter loop\n";
  for (int i = 0; i < 100'000; ++i) file += "vertex " + std::to_string(i) + " 0 1\n";
  file += "endloop\nendfacet\nendsolid\n";
  test::TestJob test;
  const auto reader =
      open_reader(test.job, std::make_unique<test::MemorySource>(file), Format::automatic,
                  Access::once, {test::usual_vertex_memory, 512});
  reader->begin_faces();
  try {
    for (RawBatch batch; reader->next_faces(batch);) REQUIRE(batch.count <= 2 * 512);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);  // refusing it would be as good
  }
}

TEST_CASE("an ASCII STL is read as other programs take it") {
  const std::string plain = test::ascii_stl(some_faces());
  const auto check = [](const std::string& file) { check_same(file, some_faces()); };
  check("\xef\xbb\xbf" + plain);
  // Words apart, words that miss.
  check(replaced(replaced(replaced(plain, "endsolid", "end solid"), "endfacet", "end facet"),
                 "endloop", "END Loop"));
  check(replaced(replaced(plain, "  facet normal 0 0 1\n", ""), "  endfacet\n", ""));
  check(replaced(replaced(plain, "  outer loop\n", ""), "  endloop\n", ""));
  check(
      replaced(replaced(replaced(replaced(plain, "  facet normal 0 0 1\n", ""), "  endfacet\n", ""),
                        "  outer loop\n", ""),
               "  endloop\n", ""));
  // Lines that are no part of a face.
  for (const std::string line :
       {"# facet", "// solid vertex 1 2 3", "; endsolid", "  # a comment", "#"}) {
    CAPTURE(line);
    check(line + "\n" + plain);
    check(replaced(plain, "  facet", line + "\n  facet"));
    check(replaced(plain, "  endloop\n", "  endloop\n" + line + "\n"));
    check(replaced(plain, "  outer loop\n", "  outer loop\n" + line + "\n"));
    check(plain + line);
  }
  check("made by a program, facet by facet\n\n" + plain);
  check(plain + "\n  \nfacet count: 40\nvertex count: 120\nendsolid is above\n");
  check(plain + "solid b\nendsolid b\nand some text\n");
}

TEST_CASE("an ASCII STL may stand on one line") {
  const auto one_line = [](const std::string& text) { return replaced(text, "\n", " "); };
  const std::string plain = test::ascii_stl(some_faces());
  check_same(one_line(plain), some_faces());
  check_same(one_line(test::ascii_stl(some_faces(), {.name = ""})), some_faces());
  check_same(one_line(test::ascii_stl(some_faces(), {.upper_case = true, .end = false})),
             some_faces());
  std::vector<test::Triangle> twice = some_faces();
  twice.insert(twice.end(), some_faces().begin(), some_faces().end());
  check_same(one_line(plain + plain), twice);
  check_same(one_line(plain) + "\n" + one_line(plain) + "\n", twice);
}

TEST_CASE("colours in an ASCII STL are named as not carried") {
  const std::string plain = test::ascii_stl(some_faces());
  for (const std::string& file :
       {replaced(plain, "  facet", "  color 0.5 0.5 1\n  facet"),
        replaced(plain, "  endloop", "  COLOR 0.5 0.5 1\n  endloop"),
        replaced(replaced(plain, "  endfacet", "  color 0.5 0.5 1\n  endfacet"), "\n", " ")}) {
    CAPTURE(file.substr(0, 300));
    check_same(file, some_faces());
    test::TestJob test;
    test::faces_of(test.job, std::make_unique<test::MemorySource>(file));
    CHECK(test.job.notes == std::vector<std::string>{"not carried: colours of faces"});
  }
}

TEST_CASE("what does not belong into a facet is an error with its line") {
  const std::string good = test::ascii_stl(some_faces());
  struct Wrong {
    std::string from, to;
    int line;
  };
  for (const Wrong& wrong : std::vector<Wrong>{{"endfacet\n  facet", "facet", 8},
                                               {"vertex ", "vertex x", 4},
                                               {"solid test\n  facet", "solid test\n  fact", 2}}) {
    std::string file = good;
    file.replace(file.find(wrong.from), wrong.from.size(), wrong.to);
    CAPTURE(file.substr(0, 300));
    const Error error = test::error_of([&] { test::faces_of(file); });
    CAPTURE(error.what());
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK(std::string(error.what()).find("line " + std::to_string(wrong.line) + ",") !=
          std::string::npos);
  }
}

}  // namespace winnow
