// Cancelling stops within a second and leaves nothing behind; progress is told in faces.
#include <winnow/error.hpp>

#include "surface_mesh.hpp"

#include <catch2/catch.hpp>

namespace winnow {

TEST_CASE("a cancelled run stops and leaves nothing") {
  for (const char* name : {"mesh.ply", "mesh.stl"}) {
    const test::Directory directory;
    Context context;
    context.threads = 2;
    context.progress = [&](const Progress& progress) {
      if (progress.done > 0) context.cancel();
    };
    bool cancelled = false;
    try {
      generate(context, directory.file(name), generate_options(Surface::scan, 1'000'000'000));
    } catch (const Error& error) {
      cancelled = error.kind() == ErrorKind::cancelled;
    }
    CHECK(cancelled);
    CHECK(directory.names().empty());
  }
}

TEST_CASE("progress counts the faces and never runs back") {
  for (const char* name : {"mesh.ply", "mesh.stl"}) {
    const test::Directory directory;
    Context context;
    context.threads = 2;
    std::uint64_t done = 0;
    std::uint64_t total = 0;
    bool forwards = true;
    context.progress = [&](const Progress& progress) {
      forwards = forwards && progress.done >= done && progress.done <= progress.total;
      done = progress.done;
      total = progress.total;
    };
    const GenerateReport report =
        generate(context, directory.file(name), generate_options(Surface::scan, 2'000'000));
    CHECK(forwards);
    CHECK(total == 2'000'000);
    CHECK(report.faces == 2'000'000);
    CHECK(report.bytes == std::filesystem::file_size(directory.file(name)));
  }
}

}  // namespace winnow
