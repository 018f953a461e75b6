#include "generate/stream.hpp"

#include "base/hash.hpp"
#include "base/parallel.hpp"
#include "io/arena.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace winnow {

namespace {

constexpr std::size_t block_size = std::size_t{1}
                                   << 14;  // vertices or faces; about two milliseconds of work

// Finds out which corners of a block are the same vertex: a table with one place for each hash.
// Whoever loses his place to another is computed again, which costs time but changes nothing.
class SharedCorners {
  static constexpr unsigned place_bits = 15;
  static constexpr std::size_t places = std::size_t{1} << place_bits;

 public:
  static constexpr std::uint64_t table_bytes =
      places * (sizeof(std::uint64_t) + sizeof(std::uint32_t));

  SharedCorners() : tag_(places), slot_(places) { ids_.reserve(3 * block_size); }

  void clear() {
    std::fill(tag_.begin(), tag_.end(), UINT64_MAX);
    ids_.clear();
  }
  // The place of the vertex in ids().
  std::uint32_t add(std::uint64_t id) {
    const std::size_t place = quick_hash(id) >> (64 - place_bits);
    if (tag_[place] != id) {
      tag_[place] = id;
      slot_[place] = static_cast<std::uint32_t>(ids_.size());
      ids_.push_back(id);
    }
    return slot_[place];
  }
  [[nodiscard]] std::span<const std::uint64_t> ids() const { return ids_; }

 private:
  std::vector<std::uint64_t> tag_;
  std::vector<std::uint32_t> slot_;
  std::vector<std::uint64_t> ids_;
};

// Everything that one block needs on its way, kept for the next.
struct BlockWork {
  bool of_faces = false;
  std::uint64_t first = 0;
  std::size_t count = 0;
  std::vector<std::uint64_t> ids;
  std::vector<Point> points;
  std::vector<MeshVertex> vertices;
  std::vector<MeshFace> faces;
  std::vector<std::array<std::uint32_t, 3>> slots;
  std::vector<Corners> corners;
  std::vector<std::byte> bytes;
  SharedCorners shared;
};

// What a block comes to hold at most: an STL file in which no corner is shared.
constexpr std::uint64_t block_bytes =
    block_size *
        (sizeof(std::uint64_t) + sizeof(MeshFace) +
         3 * sizeof(std::uint32_t) +                                      // ids, faces, slots
         3 * (sizeof(std::uint64_t) + sizeof(Point)) + sizeof(Corners) +  // corners, shared or not
         50) +                                                            // encoded
    SharedCorners::table_bytes;

class Streaming {
 public:
  Streaming(Job& job, const SurfaceFile& file, ByteSink& sink)
      : job_(job),
        file_(file),
        sink_(sink),
        scatter_(file.shape.faces, file.options.seed),
        // A format without vertices of its own has only faces to write.
        vertices_(file.encoder.needs_corners() ? 0 : file.shape.vertices) {}

  void run();

 private:
  bool begin(BlockWork& block);
  void fill(BlockWork& block) const;
  void fill_vertices(BlockWork& block) const;
  void fill_faces(BlockWork& block) const;
  void finish(const BlockWork& block);
  void evaluate(std::span<const std::uint64_t> ids, std::vector<Point>& points) const;

  Job& job_;
  const SurfaceFile& file_;
  ByteSink& sink_;
  Scatter scatter_;
  std::uint64_t vertices_;
  std::uint64_t next_vertex_ = 0, next_face_ = 0;
};

bool Streaming::begin(BlockWork& block) {
  block.of_faces = next_vertex_ == vertices_;
  std::uint64_t& next = block.of_faces ? next_face_ : next_vertex_;
  const std::uint64_t end = block.of_faces ? file_.shape.faces : vertices_;
  block.first = next;
  block.count = static_cast<std::size_t>(std::min<std::uint64_t>(block_size, end - next));
  next += block.count;
  return block.count > 0;
}

void Streaming::evaluate(std::span<const std::uint64_t> ids, std::vector<Point>& points) const {
  points.resize(ids.size());
  file_.surface.positions(ids, points);
  const auto& offset = file_.options.offset;
  for (Point& point : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += offset[axis];
  }
}

void Streaming::fill(BlockWork& block) const {
  job_.progress.check_cancelled();
  block.ids.resize(block.count);
  std::iota(block.ids.begin(), block.ids.end(), block.first);
  block.bytes.clear();
  block.of_faces ? fill_faces(block) : fill_vertices(block);
}

void Streaming::fill_vertices(BlockWork& block) const {
  evaluate(block.ids, block.points);
  block.vertices.resize(block.count);
  for (std::size_t k = 0; k < block.count; ++k) block.vertices[k].position = block.points[k];
  file_.encoder.vertices(file_.shape, block.first, block.vertices, block.bytes);
}

void Streaming::fill_faces(BlockWork& block) const {
  if (file_.options.shuffle) {
    for (std::uint64_t& id : block.ids) id = scatter_(id);
  }
  block.faces.resize(block.count);
  file_.surface.corners(block.ids, block.faces);
  if (file_.encoder.needs_corners()) {
    block.shared.clear();
    block.slots.resize(block.count);
    for (std::size_t k = 0; k < block.count; ++k) {
      for (std::size_t n = 0; n < 3; ++n)
        block.slots[k][n] = block.shared.add(block.faces[k].vertex[n]);
    }
    evaluate(block.shared.ids(), block.points);
    block.corners.resize(block.count);
    for (std::size_t k = 0; k < block.count; ++k) {
      for (std::size_t n = 0; n < 3; ++n) block.corners[k][n] = block.points[block.slots[k][n]];
    }
  }
  file_.encoder.faces(file_.shape, block.first, block.faces, block.corners, block.bytes);
}

void Streaming::finish(const BlockWork& block) {
  sink_.write(block.bytes);
  // Progress is told in faces; where there are vertices, they are the first half of the way.
  const auto faces = static_cast<double>(file_.shape.faces);
  const double half = vertices_ > 0 ? faces / 2 : 0;
  const auto done = [&](std::uint64_t number) {
    const auto part = static_cast<double>(number);
    return static_cast<std::uint64_t>(block.of_faces
                                          ? half + part * ((faces - half) / faces)
                                          : part * (half / static_cast<double>(vertices_)));
  };
  job_.progress.advance(done(block.first + block.count) - done(block.first));
}

void Streaming::run() {
  // Two blocks a thread keep all busy while one is written; fewer do where the budget is small.
  std::vector<Reservation> reservations;
  reservations.push_back(job_.budget.reserve(block_bytes, "generating"));
  while (reservations.size() < 2 * std::size_t{job_.threads}) {
    Reservation more = job_.budget.try_reserve(block_bytes);
    if (!more) break;
    reservations.push_back(std::move(more));
  }
  job_.progress.begin("generate", file_.shape.faces, "faces");
  in_arena(job_, [&] {
    pipeline<BlockWork>(
        reservations.size(), [this](BlockWork& block) { return begin(block); },
        [this](BlockWork& block) { fill(block); },
        [this](const BlockWork& block) { finish(block); });
  });
}

}  // namespace

void stream_surface(Job& job, const SurfaceFile& file, ByteSink& sink) {
  Streaming(job, file, sink).run();
  const std::string footer = file.encoder.footer(file.shape);
  sink.write(std::as_bytes(std::span(footer)));
}

}  // namespace winnow
