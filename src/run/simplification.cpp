// A mesh that comes in batches is kept as the file that it would be, which then takes the usual
// pipeline.
#include <winnow/error.hpp>
#include <winnow/simplification.hpp>

#include "base/memory_shares.hpp"
#include "io/arena.hpp"
#include "io/spool.hpp"
#include "io/spooled_source.hpp"
#include "run/map_sink.hpp"
#include "run/mesh_sink.hpp"
#include "run/plan.hpp"
#include "run/simplify_options.hpp"
#include "run/simplify_source.hpp"
#include "write/formats.hpp"

#include <array>
#include <cstring>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace winnow {

namespace {

constexpr std::size_t faces_at_once = 4096;  // encoded at once

SimplifyOptions checked(SimplifyOptions options) {
  check(options);
  options.from = Format::automatic;
  return options;
}

// Of what is left of the budget beside the smallest that works.
std::uint64_t memory_of_mesh(const Job& job, const SimplifyOptions& options) {
  MemoryPlan::divide(job.budget.total(), job.budget.used(), job.threads, needs_of(options));
  const std::uint64_t needed = MemoryPlan::smallest_for(job.threads, needs_of(options));
  return share::left::added_mesh(job.budget.left() - needed);
}

}  // namespace

struct Simplification::State {
  // `path`: of a file; nothing for memory.
  State(Context& context, const std::optional<std::string>& path, const SimplifyOptions& asked)
      : options(checked(asked)), job(context) {
    expect_plan(job, options);
    if (path) {
      sinks = sinks_to(job, *path, options);
    } else {
      results.resize(1 + options.coarser.size());
      sinks = sinks_into(job, results, options);
    }
    vertices = std::make_unique<Spool>(job, memory_of_mesh(job, options));
    faces = std::make_unique<Spool>(job, memory_of_mesh(job, options));
  }

  template <typename Real>
  void set_type(bool triangles) {
    constexpr bool real_is_double = sizeof(Real) == sizeof(double);
    if (doubles.value_or(real_is_double) != real_is_double)
      throw Error(ErrorKind::usage,
                  "positions were added as floats and as doubles; keep to one of them");
    set_kind(triangles);
    doubles = real_is_double;
  }

  void set_kind(bool triangles) {
    if (soup.value_or(triangles) != triangles)
      throw Error(
          ErrorKind::usage,
          "triangles of their own were added beside vertices and faces; keep to one of them");
    soup = triangles;
    job.progress.check_cancelled();
  }

  template <typename Real>
  void add_vertices(std::span<const Real> coordinates) {
    if (coordinates.size() % 3 != 0)
      throw Error(ErrorKind::usage, "a vertex takes three coordinates");
    vertex_count += coordinates.size() / 3;
    if (vertex_count > UINT32_MAX)
      throw Error(ErrorKind::usage,
                  "more vertices were added than 32 bits count; add triangles instead");
    vertices->append(std::as_bytes(coordinates));
  }

  // As records of a PLY.
  void add_faces(std::span<const std::uint32_t> corners) {
    if (corners.size() % 3 != 0) throw Error(ErrorKind::usage, "a face takes three vertices");
    face_count += corners.size() / 3;
    constexpr std::size_t numbers = 3 * sizeof(std::uint32_t);
    std::vector<std::byte> records;
    while (!corners.empty()) {
      const std::size_t count = std::min(corners.size() / 3, faces_at_once);
      records.assign(count * (1 + numbers), std::byte{3});
      for (std::size_t i = 0; i < count; ++i)
        std::memcpy(records.data() + i * (1 + numbers) + 1, corners.data() + 3 * i, numbers);
      faces->append(records);
      corners = corners.subspan(3 * count);
    }
  }

  void add_triangles(std::span<const double> coordinates) {
    const std::size_t count = coordinates.size() / 9;
    std::vector<std::uint32_t> own(3 * faces_at_once);
    for (std::size_t done = 0; done < count; done += faces_at_once) {
      const std::size_t part = std::min(count - done, faces_at_once);
      std::iota(own.begin(), own.end(), static_cast<std::uint32_t>(vertex_count));
      add_vertices(coordinates.subspan(9 * done, 9 * part));
      add_faces(std::span(own).first(3 * part));
    }
  }

  // As records of an STL.
  void add_triangles(std::span<const float> coordinates) {
    constexpr std::size_t record = 50;
    constexpr std::size_t normal = 12;
    std::vector<std::byte> records;
    for (; !coordinates.empty();) {
      const std::size_t count = std::min(coordinates.size() / 9, faces_at_once);
      records.assign(count * record, std::byte{0});
      for (std::size_t i = 0; i < count; ++i)
        std::memcpy(records.data() + i * record + normal, coordinates.data() + 9 * i,
                    9 * sizeof(float));
      faces->append(records);
      coordinates = coordinates.subspan(9 * count);
      face_count += count;
    }
  }

  SimplifyReport finish() {
    const Stopwatch watch;
    std::vector<std::unique_ptr<Spool>> spools;
    for (std::unique_ptr<Spool>* spool : {&vertices, &faces}) {
      if (*spool == nullptr) throw Error(ErrorKind::usage, "the mesh was finished before");
      (*spool)->finish();
      spools.push_back(std::move(*spool));
    }
    if (face_count == 0) throw Error(ErrorKind::bad_input, "no face was added");
    return in_arena(job, [&] {
      Input input(job, spooled_source("what was added", head(), std::move(spools)));
      return simplify_input(job, std::move(input), sinks, open_map(job, options, sinks).get(),
                            options, watch);
    });
  }

  [[nodiscard]] std::string head() const {
    if (soup.value_or(false) && !doubles.value_or(false))
      return stl_output.make({})->header({.faces = face_count});
    return ply_output.make({})->header({.vertices = vertex_count,
                                        .faces = face_count,
                                        .double_positions = doubles.value_or(false)});
  }

  SimplifyOptions options;
  Job job;
  std::vector<Mesh> results;
  MeshSinks sinks;
  std::unique_ptr<Spool> vertices, faces;
  std::uint64_t vertex_count = 0, face_count = 0;
  std::optional<bool> soup, doubles;
};

Simplification::Simplification(Context& context, const std::string& output,
                               const SimplifyOptions& options)
    : state_(std::make_unique<State>(context, output, options)) {}

Simplification::Simplification(Context& context, const SimplifyOptions& options)
    : state_(std::make_unique<State>(context, std::nullopt, options)) {}

Simplification::~Simplification() = default;

void Simplification::add_vertices(std::span<const float> coordinates) {
  state_->set_type<float>(false);
  state_->add_vertices(coordinates);
}

void Simplification::add_vertices(std::span<const double> coordinates) {
  state_->set_type<double>(false);
  state_->add_vertices(coordinates);
}

void Simplification::add_faces(std::span<const std::uint32_t> corners) {
  state_->set_kind(false);
  state_->add_faces(corners);
}

namespace {

template <typename Real>
void check_triangles(std::span<const Real> coordinates) {
  if (coordinates.size() % 9 != 0)
    throw Error(ErrorKind::usage, "a triangle takes nine coordinates");
}

}  // namespace

void Simplification::add_triangles(std::span<const float> coordinates) {
  check_triangles(coordinates);
  state_->set_type<float>(true);
  state_->add_triangles(coordinates);
}

void Simplification::add_triangles(std::span<const double> coordinates) {
  check_triangles(coordinates);
  state_->set_type<double>(true);
  state_->add_triangles(coordinates);
}

SimplifyReport Simplification::finish() {
  if (state_->sinks.front()->name().empty())
    throw Error(ErrorKind::usage, "no output was named; finish_mesh() gives the mesh");
  return state_->finish();
}

std::vector<Mesh> Simplification::finish_meshes(SimplifyReport* report) {
  if (!state_->sinks.front()->name().empty())
    throw Error(ErrorKind::usage, "the mesh goes to a file; finish() writes it");
  SimplifyReport told = state_->finish();
  if (report != nullptr) *report = std::move(told);
  return std::move(state_->results);
}

Mesh Simplification::finish_mesh(SimplifyReport* report) {
  refuse_levels(state_->options);
  return std::move(finish_meshes(report).front());
}

}  // namespace winnow
