// What is wrong with a mesh in memory is told by the array's name, and nothing behind the arrays is
// read.
#include <winnow/mesh.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/mesh_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <catch2/catch.hpp>
#include <sys/mman.h>
#include <unistd.h>

namespace winnow::test {

namespace {

SimplifyOptions to_some_faces() {
  SimplifyOptions options;
  options.target = Target::faces(500);
  return options;
}

struct Refused {
  Context context;
  Directory directory;
  Refused() { context.scratch = directory.path(); }

  Error operator()(const MeshView& view, const SimplifyOptions& options = to_some_faces()) {
    const Error error = error_of([&] { simplify(context, view, options); });
    CHECK(directory.names().empty());
    return error;
  }
};

// Numbers whose last byte is the last that may be read.
template <typename T>
class Guarded {
 public:
  explicit Guarded(const std::vector<T>& numbers) : count_(numbers.size()) {
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const std::size_t bytes = count_ * sizeof(T);
    const std::size_t pages = (bytes + page - 1) / page * page;
    size_ = pages + page;
    memory_ = static_cast<std::byte*>(
        ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    REQUIRE(memory_ != MAP_FAILED);
    REQUIRE(::mprotect(memory_ + pages, page, PROT_NONE) == 0);
    first_ = reinterpret_cast<T*>(memory_ + pages - bytes);
    std::memcpy(first_, numbers.data(), bytes);
  }
  ~Guarded() { ::munmap(memory_, size_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  [[nodiscard]] std::span<const T> span() const { return {first_, count_}; }

 private:
  std::size_t count_, size_ = 0;
  std::byte* memory_ = nullptr;
  T* first_ = nullptr;
};

bool names(const Error& error, const std::string& what) {
  INFO(error.what());
  CHECK(std::string(error.what()).find(what) != std::string::npos);
  return std::string(error.what()).find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("arrays whose sizes do not fit are refused by name", "[library]") {
  Refused refused;
  const Mesh mesh = ball_arrays(10, false, true);
  const auto& xyz = std::get<std::vector<float>>(mesh.positions);
  const auto with = [&](const auto& change) {
    MeshView view = mesh.view();
    change(view);
    return refused(view);
  };
  const std::span<const float> all(xyz);
  Error error = with([&](MeshView& view) { view.positions = all.first(xyz.size() - 1); });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "`positions`"));
  error = with([&](MeshView& view) { view.faces = std::span(mesh.faces).first(8); });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "`faces`"));
  error = with([&](MeshView& view) { view.attributes[1].values = all.first(5); });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "`attributes`: 'green'"));
  error = with([&](MeshView& view) { view.positions = {}; });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "`positions` is empty"));
  error = with([&](MeshView& view) { view.faces = {}; });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "`faces` is empty"));
  CHECK(refused({}).kind() == ErrorKind::bad_input);
  error = with([&](MeshView& view) { view.positions = {xyz.data(), 4, 8}; });
  CHECK(error.kind() == ErrorKind::usage);
  CHECK(names(error, "`positions`"));
  error = with([&](MeshView& view) {
    view.faces = {static_cast<const std::uint32_t*>(nullptr), 4, 12};
  });
  CHECK(error.kind() == ErrorKind::usage);
  CHECK(names(error, "`faces`"));
  error = with([&](MeshView& view) { view.positions = {xyz.data(), std::uint64_t{1} << 32, 12}; });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "`positions` holds 4,294,967,296 vertices"));
}

TEST_CASE("arrays of wrong types and attributes without a proper name are refused", "[library]") {
  Refused refused;
  const Mesh mesh = ball_arrays(10, false, true);
  const auto with = [&](const auto& change, const std::string& what) {
    MeshView view = mesh.view();
    change(view);
    const Error error = refused(view);
    CHECK(error.kind() == ErrorKind::usage);
    return names(error, what);
  };
  const std::vector<std::int16_t> shorts(3);
  const std::vector<std::int64_t> wide(mesh.vertex_count());
  CHECK(with([&](MeshView& view) { view.positions = mesh.faces; }, "`positions` takes floats"));
  CHECK(with([&](MeshView& view) { view.faces = shorts; }, "`faces` takes whole numbers"));
  CHECK(with([&](MeshView& view) { view.faces = view.positions; }, "`faces` takes whole numbers"));
  CHECK(with([&](MeshView& view) { view.attributes[0].values = wide; }, "`attributes`: 'red'"));
  CHECK(with([&](MeshView& view) { view.attributes[0].name = "green"; }, "'green' twice"));
  for (const char* name : {"", "two words", "line\nend", "x", "z"})
    CHECK(with([&](MeshView& view) { view.attributes[0].name = name; }, "`attributes`: '"));
  SimplifyOptions options = to_some_faces();
  options.attributes = {"nothing"};
  CHECK(names(refused(mesh.view(), options), "'attributes': 'nothing' is no attribute"));
}

TEST_CASE("options that ask for a format are refused for a mesh in memory", "[library]") {
  Refused refused;
  const Mesh mesh = ball_arrays(10, false, false);
  std::vector<SimplifyOptions> all(5, to_some_faces());
  all[0].to = Format::gltf;
  all[1].encoding.ascii = true;
  all[2].encoding.compress = Compression::meshopt;
  all[3].encoding.up = UpAxis::z;
  all[4].encoding.quantize = 12;
  for (const SimplifyOptions& options : all)
    CHECK(refused(mesh.view(), options).kind() == ErrorKind::usage);
}

TEST_CASE("faces with an index of no vertex are counted and left out", "[library]") {
  Context context;
  const Mesh mesh = ball_arrays(20, false, false);
  const std::string right = ply_of_arrays(simplify(context, mesh.view(), to_some_faces()));
  const auto check = [&](auto index, const auto& bad_indices) {
    using Index = decltype(index);
    std::vector<Index> faces(mesh.faces.begin(), mesh.faces.end());
    for (const Index bad : bad_indices) faces.insert(faces.end(), {Index{0}, bad, Index{1}});
    MeshView view = mesh.view();
    view.faces = faces;
    SimplifyReport report;
    CHECK((ply_of_arrays(simplify(context, view, to_some_faces(), &report)) == right));
    CHECK(report.input.bad_faces.out_of_range == bad_indices.size());
    SimplifyOptions strict = to_some_faces();
    strict.strict = true;
    const Error error = error_of([&] { simplify(context, view, strict); });
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK(names(error, "'faces': face 1,520 names a vertex that does not exist"));
  };
  REQUIRE(mesh.face_count() == 1520);
  const auto count = static_cast<std::uint32_t>(mesh.vertex_count());
  check(std::uint32_t{}, std::vector<std::uint32_t>{count, UINT32_MAX});
  check(std::int32_t{}, std::vector<std::int32_t>{-1, INT32_MIN, INT32_MAX});
  // Of which the lower half is the number of a vertex.
  constexpr std::int64_t wrapped = (std::int64_t{1} << 32) + 3;
  check(std::int64_t{}, std::vector<std::int64_t>{wrapped, -wrapped, INT64_MIN, INT64_MAX});
  check(std::uint64_t{}, std::vector<std::uint64_t>{wrapped, UINT64_MAX, UINT32_MAX});
}

TEST_CASE("positions that are not finite are counted, and all of them are an error", "[library]") {
  Context context;
  Mesh mesh = ball_arrays(20, false, false);
  auto& xyz = std::get<std::vector<float>>(mesh.positions);
  xyz[300] = std::numeric_limits<float>::quiet_NaN();
  SimplifyReport report;
  const Mesh result = simplify(context, mesh.view(), to_some_faces(), &report);
  CHECK(report.input.bad_faces.non_finite == 6);
  const auto& left = std::get<std::vector<float>>(result.positions);
  CHECK(std::all_of(left.begin(), left.end(), [](float number) { return std::isfinite(number); }));
  std::fill(xyz.begin(), xyz.end(), std::numeric_limits<float>::infinity());
  const Error error = error_of([&] { simplify(context, mesh.view(), to_some_faces()); });
  CHECK(error.kind() == ErrorKind::bad_input);
  CHECK(names(error, "'faces' has no face that could be simplified"));
}

TEST_CASE("nothing behind the arrays is read", "[library]") {
  Context context;
  for (const bool attributes : {false, true}) {
    const Mesh mesh = ball_arrays(25, attributes, attributes);
    const std::string right = ply_of_arrays(simplify(context, mesh.view(), to_some_faces()));
    MeshView view = mesh.view();
    const Guarded<std::uint32_t> faces(mesh.faces);
    view.faces = faces.span();
    std::visit(
        [&]<typename Real>(const std::vector<Real>& numbers) {
          const Guarded<Real> positions(numbers);
          view.positions = positions.span();
          CHECK((ply_of_arrays(simplify(context, view, to_some_faces())) == right));
          if (!attributes) return;
          // As far apart as the positions, so that they are read in place.
          std::vector<double> apart;
          for (const double heat : std::get<std::vector<double>>(mesh.attributes[4].values))
            apart.insert(apart.end(), {heat, 0, 0});
          apart.resize(apart.size() - 2);
          const Guarded<double> heat(apart);
          view.attributes = {{"heat", {heat.span().data(), mesh.vertex_count(), 24}}};
          SimplifyOptions only = to_some_faces();
          only.attributes = {"heat"};
          const std::string of_heat = ply_of_arrays(simplify(context, mesh.view(), only));
          CHECK((ply_of_arrays(simplify(context, view, only)) == of_heat));
        },
        mesh.positions);
  }
}

}  // namespace winnow::test
