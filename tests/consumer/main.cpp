// Makes a mesh in memory small, and the file of another, and checks the counts. HAS_GLTF and
// HAS_COMPARE say which parts the library was built with; the others are missed by name.
#include <winnow/compare.hpp>
#include <winnow/error.hpp>
#include <winnow/mesh.hpp>
#include <winnow/parts.hpp>
#include <winnow/version.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

// A bumpy square of 20,000 triangles.
struct Square {
  std::vector<float> positions;
  std::vector<std::uint32_t> faces;

  Square() {
    constexpr std::uint32_t rows = 100;
    for (std::uint32_t i = 0; i <= rows; ++i) {
      for (std::uint32_t j = 0; j <= rows; ++j) {
        const float height = static_cast<float>((i % 10) * (j % 10)) / 100.0F;
        positions.insert(positions.end(), {static_cast<float>(i), static_cast<float>(j), height});
        if (i == 0 || j == 0) continue;
        const std::uint32_t here = i * (rows + 1) + j;
        const std::uint32_t below = here - (rows + 1);
        faces.insert(faces.end(), {below - 1, below, here, below - 1, here, here - 1});
      }
    }
  }
};

// Whether `call` works if the library has the part, and else throws MissingPart for it.
template <typename Call>
bool as_built(winnow::Part part, bool built, Call call) {
  if (winnow::has_part(part) != built) return false;
  try {
    call();
    return built;
  } catch (const winnow::MissingPart& missing) {
    std::printf("%s\n", missing.what());
    return !built && missing.part() == part && missing.kind() == winnow::ErrorKind::failed;
  }
}

}  // namespace

int main() {
  try {
    const Square square;
    winnow::MeshView view;
    view.positions = square.positions;
    view.faces = square.faces;

    winnow::Context context;
    context.memory = std::uint64_t{256} << 20;
    winnow::SimplifyOptions options;
    options.target = winnow::Target::faces(1'000);
    options.force = true;
    const winnow::Mesh mesh = winnow::simplify(context, view, options);

    // The examples of docs/library.md have a scan.ply beside them.
    options.target = winnow::Target::faces(10'000);
    winnow::simplify(context, view, "scan.ply", options);
    options.target = winnow::Target::faces(1'000);
    const winnow::SimplifyReport report =
        winnow::simplify(context, "scan.ply", "small.ply", options);

    const bool gltf = as_built(winnow::Part::gltf, HAS_GLTF,
                               [&] { winnow::simplify(context, view, "small.glb", options); });
    const bool comparing = as_built(winnow::Part::compare, HAS_COMPARE, [&] {
      winnow::compare(context, "scan.ply", "small.ply", {.samples = 1'000});
    });
    std::printf("%llu and %llu faces\n", static_cast<unsigned long long>(mesh.face_count()),
                static_cast<unsigned long long>(report.output.faces));
    const auto plausible = [](std::uint64_t faces) { return faces > 500 && faces <= 1'000; };
    const bool good = plausible(mesh.face_count()) && plausible(report.output.faces);
    const bool same_version = winnow::version().major_number == WINNOW_VERSION_MAJOR &&
                              winnow::version().minor_number == WINNOW_VERSION_MINOR &&
                              winnow::version().patch_number == WINNOW_VERSION_PATCH;
    return good && gltf && comparing && same_version ? 0 : 1;
  } catch (const winnow::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
}
