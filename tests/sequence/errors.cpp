// Frames that do not belong together, and outputs that cannot be: one error, nothing written.
#include <winnow/sequence.hpp>

#include "support/job.hpp"
#include "support/moving_sheet.hpp"

#include <catch2/catch.hpp>

namespace winnow {

using namespace test;

namespace {

const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
using Faces = std::vector<std::array<std::uint32_t, 3>>;
const Faces pyramid{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

// Of a pyramid as the first frame and `second` as the second.
Error error_beside(const std::string& second) {
  const Directory directory;
  const std::vector<std::string> names{directory.file("f1.obj"), directory.file("f2.obj")};
  write_file(names[0], obj_of(corners, pyramid));
  write_file(names[1], second);
  TestJob job;
  SequenceOptions options;
  options.target = Target::faces(4);
  const Error error = error_of([&] {
    (void)simplify_sequence(job.context, names, directory.file("s-{frame}.obj"), options);
  });
  CHECK(directory.names().size() == 2);
  return error;
}

void check_names_both(const Error& error, const std::vector<std::string>& parts) {
  CHECK(error.kind() == ErrorKind::bad_input);
  const std::string message = error.what();
  INFO(message);
  CHECK(message.find("f1.obj") != std::string::npos);
  CHECK(message.find("f2.obj") != std::string::npos);
  for (const std::string& part : parts) CHECK(message.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("frames of different vertices are refused with both names and counts") {
  std::vector<Point> more = corners;
  more.push_back({5, 5, 5});
  check_names_both(error_beside(obj_of(more, pyramid)), {"6 vertices", "has 5"});
}

TEST_CASE("frames of different faces are refused with the first that differs") {
  Faces other = pyramid;
  other[2] = {2, 3, 1};
  other[3] = {3, 0, 1};
  check_names_both(error_beside(obj_of(corners, other)), {"face 2", "2, 3 and 1", "2, 3 and 4"});
  Faces turned = pyramid;
  turned[0] = {1, 0, 4};
  check_names_both(error_beside(obj_of(corners, turned)), {"face 0"});
}

TEST_CASE("frames of fewer or more faces are refused with both counts") {
  Faces fewer(pyramid.begin(), pyramid.end() - 1);
  check_names_both(error_beside(obj_of(corners, fewer)), {"has 3", "has 4"});
  Faces more = pyramid;
  more.push_back({0, 2, 1});
  check_names_both(error_beside(obj_of(corners, more)), {"has 5", "has 4"});
}

TEST_CASE("polygons that are cut differently in two frames are the same faces") {
  // A quadrilateral with a dent, that is at another corner in the second frame.
  const Directory directory;
  const std::string faces = "f 1 2 3 4\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  write_file(directory.file("q1.obj"), "v 0 0 0\nv 1 0 0\nv 0.2 0.2 0\nv 0 1 0\nv 0 0 1\n" + faces);
  write_file(directory.file("q2.obj"),
             "v 0 0 0\nv 0.8 0.8 0\nv 0 1 0\nv -1 1 0\nv 0 0 1\n" + faces);
  TestJob job;
  SequenceOptions options;
  options.target = Target::ratio(1);
  const SequenceReport report =
      simplify_sequence(job.context, {directory.file("q1.obj"), directory.file("q2.obj")},
                        directory.file("s{frame}.obj"), options);
  CHECK(report.output.faces == 6);
}

TEST_CASE("a vertex that is not finite in some frame is named with that frame") {
  std::string second = obj_of(corners, pyramid);
  second.replace(second.find("v 1.0"), 6, "v nan ");
  const Error error = error_beside(second);
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(std::string(error.what()).find("f2.obj") != std::string::npos);
  CHECK(std::string(error.what()).find("vertex 1 ") != std::string::npos);
}

TEST_CASE("an output that exists is refused before anything is read, unless forced") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {8}, 3);
  const std::string output = directory.file("s-{frame}.ply");
  write_file(directory.file("s-2.ply"), "mine");
  TestJob job;
  SequenceOptions options;
  options.target = Target::faces(20);
  const Error error =
      error_of([&] { (void)simplify_sequence(job.context, names, output, options); });
  CHECK(error.kind() == ErrorKind::usage);
  CHECK(std::string(error.what()).find("s-2.ply") != std::string::npos);
  CHECK(bytes_of_file(directory.file("s-2.ply")) == "mine");
  CHECK_FALSE(exists(directory.file("s-0.ply")));
  options.force = true;
  CHECK(simplify_sequence(job.context, names, output, options).output.names.size() == 3);
  CHECK(bytes_of_file(directory.file("s-2.ply")) != "mine");
}

TEST_CASE("a sequence that fails leaves what was there under its outputs' names") {
  const Directory directory;
  const std::vector<std::string> names = write_frames(directory, {8}, 3);
  write_file(names[2], "v 0 0 0\n");
  write_file(directory.file("s-0.ply"), "mine");
  TestJob job;
  SequenceOptions options;
  options.target = Target::faces(20);
  options.force = true;
  const Error error = error_of([&] {
    (void)simplify_sequence(job.context, names, directory.file("s-{frame}.ply"), options);
  });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(bytes_of_file(directory.file("s-0.ply")) == "mine");
}

TEST_CASE("a sequence without a count of faces, or with one mesh, is a usage error") {
  const Directory directory;
  write_file(directory.file("one.obj"), obj_of(corners, pyramid));
  TestJob job;
  SequenceOptions options;
  const auto kind_of = [&](const std::vector<std::string>& names) {
    return error_of([&] { (void)simplify_sequence(job.context, names, "{frame}.ply", options); })
        .kind();
  };
  CHECK(kind_of({"a1.ply", "a2.ply"}) == ErrorKind::usage);
  options.target = Target::cell(0.1);
  CHECK(kind_of({"a1.ply", "a2.ply"}) == ErrorKind::usage);
  options.target = Target::faces(10);
  CHECK(kind_of({directory.file("one.obj")}) == ErrorKind::usage);
  CHECK(kind_of({"a1.ply"}) == ErrorKind::bad_input);
  CHECK(kind_of({"a1.ply", "-"}) == ErrorKind::usage);
  CHECK(kind_of({"a1.ply", "a2.ply"}) == ErrorKind::bad_input);
  options.deformation_weight = -1;
  CHECK(kind_of({"a1.ply", "a2.ply"}) == ErrorKind::usage);
}

}  // namespace winnow
