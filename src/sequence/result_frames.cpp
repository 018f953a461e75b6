#include "sequence/result_frames.hpp"

#include "io/spool_records.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace winnow {

namespace {

constexpr std::uint64_t bytes_of_states = std::uint64_t{1} << 20;

// What vertices carry in some frames from `first` on.
void read_numbers(Job& job, const Spool& numbers, std::size_t all_frames, std::size_t first,
                  std::uint64_t count, std::span<std::vector<double>> frames) {
  const std::size_t carried = frames.front().size() / std::max<std::uint64_t>(count, 1);
  const std::size_t each = all_frames * carried;
  const std::size_t at_once =
      std::clamp<std::size_t>(bytes_of_states / (each * sizeof(double)), 1, 4096);
  for (std::uint64_t v = 0; v < count; v += at_once) {
    job.progress.check_cancelled();
    const std::size_t part = std::min<std::uint64_t>(at_once, count - v);
    const std::vector<double> of_part = read_records<double>(numbers, v * each, part * each);
    for (std::size_t t = 0; t < frames.size(); ++t) {
      for (std::size_t i = 0; i < part; ++i)
        std::copy_n(&of_part[i * each + (first + t) * carried], carried,
                    &frames[t][(v + i) * carried]);
    }
  }
}

// Positions of some frames from `first` on, frame after frame.
void read_frames(Job& job, const VertexIndex& first_frame, const Spool* state,
                 std::size_t state_size, std::size_t first, std::span<std::vector<Point>> frames) {
  const std::uint64_t count = first_frame.size();
  const std::size_t at_once = std::clamp<std::size_t>(
      bytes_of_states / std::max(state_size, sizeof(IndexedVertex)), 1, 4096);
  std::vector<std::byte> states;
  for (std::uint64_t v = 0; v < count; v += at_once) {
    job.progress.check_cancelled();
    const std::size_t part = std::min<std::uint64_t>(at_once, count - v);
    if (first == 0) {
      const std::vector<IndexedVertex> vertices =
          read_records<IndexedVertex>(first_frame.records(), v, part);
      for (std::size_t i = 0; i < part; ++i) frames[0][v + i] = vertices[i].position;
    }
    if (state == nullptr) continue;
    states.resize(part * state_size);
    state->read(v * state_size, states);
    for (std::size_t t = first == 0 ? 1 : 0; t < frames.size(); ++t) {
      const std::byte* from = states.data() + (first + t - 1) * sizeof(Point);
      for (std::size_t i = 0; i < part; ++i, from += state_size)
        std::memcpy(&frames[t][v + i], from, sizeof(Point));
    }
  }
}

std::vector<Point> normals_of(Job& job, const StoredMesh& mesh, std::span<const Point> positions) {
  std::vector<Point> normals(positions.size(), Point{});
  SpoolCursor<FaceVertices> faces = mesh.face_cursor(job);
  for (FaceVertices face{}; faces.next(face);) {
    const Point normal = doubled_area({positions[face[0]], positions[face[1]], positions[face[2]]});
    for (const std::uint32_t v : face) normals[v] = normals[v] + normal;
  }
  return normals;
}

}  // namespace

void for_each_result_frame(Job& job, StoredMesh& mesh, std::size_t frames, std::size_t first,
                           std::uint64_t memory,
                           const std::function<void(std::size_t frame)>& each) {
  const std::unique_ptr<VertexIndex> first_frame = std::move(mesh.vertices);
  const std::unique_ptr<Spool> numbers = std::move(mesh.attributes);
  const std::size_t carried = mesh.layout.attributes / frames;
  mesh.layout.attributes = carried;
  const std::uint64_t count = first_frame->size();
  const std::uint64_t frame_bytes = count * (sizeof(Point) + carried * sizeof(double));
  // Beside the positions there are the normals of one frame.
  const std::uint64_t held = frame_bytes > 0 ? memory / 2 / frame_bytes : frames;
  const std::size_t at_once = std::clamp<std::uint64_t>(held, 2, frames + 1) - 1;
  const Reservation reserved =
      job.budget.reserve((at_once + 1) * frame_bytes, "frames of the result");
  std::vector<std::vector<Point>> positions(at_once, std::vector<Point>(count));
  std::vector<std::vector<double>> values(numbers != nullptr ? at_once : 0,
                                          std::vector<double>(count * carried));
  for (; first < frames; first += at_once) {
    const std::size_t now = std::min(at_once, frames - first);
    read_frames(job, *first_frame, mesh.state.get(), mesh.layout.state, first,
                std::span(positions).first(now));
    if (numbers != nullptr && count > 0)
      read_numbers(job, *numbers, frames, first, count, std::span(values).first(now));
    for (std::size_t t = 0; t < now; ++t) {
      const std::vector<Point> normals = normals_of(job, mesh, positions[t]);
      mesh.vertices = std::make_unique<VertexIndex>(job, memory / 2);
      SpoolCursor<IndexedVertex> keys(job, first_frame->records());
      Appender<IndexedVertex, VertexIndex> append(job, *mesh.vertices);
      IndexedVertex vertex;
      for (std::uint64_t v = 0; keys.next(vertex); ++v) {
        vertex.position = positions[t][v];
        const double size = length(normals[v]);
        vertex.normal = {};
        for (std::size_t axis = 0; axis < 3 && size > 0; ++axis)
          vertex.normal.at(axis) = static_cast<float>(normals[v][axis] / size);
        append.add(vertex);
      }
      append.flush();
      mesh.vertices->finish();
      if (numbers != nullptr) {
        mesh.attributes = std::make_unique<Spool>(job, memory / 4);
        mesh.attributes->append(std::as_bytes(std::span(values[t])));
        mesh.attributes->finish();
      }
      each(first + t);
    }
  }
}

}  // namespace winnow
