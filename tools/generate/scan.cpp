// A closed surface like the scan of a sculpture: rings of rows from the crown to the base, in the
// order in which a turntable scanner sees them, and a fan of faces at either end.
#include "generate/circle.hpp"
#include "generate/profile.hpp"
#include "generate/relief.hpp"
#include "generate/row_grid.hpp"
#include "generate/surface.hpp"

#include <algorithm>

namespace winnow {

namespace {

class Scan final : public GeneratedSurface {
 public:
  explicit Scan(const GenerateOptions& options)
      : profile_(options.seed),
        relief_(options.seed),
        grid_(nearest_grid(options.faces / 2, profile_.proportion(), {3, 1})) {}

  [[nodiscard]] std::uint64_t vertices() const override { return grid_.columns * grid_.rows + 2; }
  [[nodiscard]] std::uint64_t faces() const override { return 2 * grid_.columns * grid_.rows; }

  void positions(std::span<const std::uint64_t> ids, std::span<Point> points) const override {
    for (std::size_t at = 0; at < ids.size(); at += batch_points) {
      const std::size_t count = std::min(batch_points, ids.size() - at);
      evaluate(ids.subspan(at, count), points.subspan(at, count));
    }
  }

  void corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const override;

 private:
  struct Batch {
    PointBatch rough;                             // points of the rough shape
    std::array<double, batch_points> dx, dy, dz;  // the directions in which the relief raises them
  };

  void evaluate(std::span<const std::uint64_t> ids, std::span<Point> points) const;
  void lay_ring(std::uint64_t row, std::int32_t column, std::size_t from, std::size_t to,
                Batch& batch) const;

  Profile profile_;
  Relief relief_;
  RowGrid grid_;
};

// Points `from` to `to` of the batch become those of one ring, from `column` on. Row 0 is the
// crown, row rows + 1 the middle of the base.
void Scan::lay_ring(std::uint64_t row, std::int32_t column, std::size_t from, std::size_t to,
                    Batch& batch) const {
  const Ring ring = profile_.ring(static_cast<double>(row) / static_cast<double>(grid_.rows + 1));
  const auto columns = static_cast<double>(grid_.columns);
  for (std::size_t k = from; k < to; ++k) {
    const auto [c1, s1] = on_circle((column + static_cast<std::int32_t>(k - from)) / columns);
    const double c2 = c1 * c1 - s1 * s1;
    const double s2 = 2 * (s1 * c1);
    const double c3 = c1 * c2 - s1 * s2;
    const double radius =
        ring.radius * (1 + ring.cosine[0] * c1 + ring.cosine[1] * c2 + ring.cosine[2] * c3 +
                       ring.sine[0] * s1 + ring.sine[1] * s2);
    batch.rough.x[k] = radius * c1;
    batch.rough.y[k] = radius * s1;
    batch.rough.z[k] = ring.height;
    batch.dx[k] = ring.out * c1;
    batch.dy[k] = ring.out * s1;
    batch.dz[k] = ring.up;
  }
}

void Scan::evaluate(std::span<const std::uint64_t> ids, std::span<Point> points) const {
  Batch batch;
  batch.rough.count = ids.size();
  const std::uint64_t last = vertices() - 1;
  RowFinder finder(grid_.columns);
  for (std::size_t from = 0; from < ids.size();) {
    std::uint64_t row = 0;
    std::uint64_t column = 0;
    std::uint64_t left = 1;  // vertices from this one to the end of its ring
    if (ids[from] == last) {
      row = grid_.rows + 1;
    } else if (ids[from] > 0) {
      finder.find(ids[from] - 1);
      row = finder.row() + 1;
      column = ids[from] - 1 - finder.begin();
      left = grid_.columns - column;
    }
    std::size_t to = from + 1;
    while (to < ids.size() && to - from < left && ids[to] == ids[to - 1] + 1) ++to;
    lay_ring(row, static_cast<std::int32_t>(column), from, to, batch);
    from = to;
  }
  NoiseValues height;
  relief_.heights(batch.rough, height);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    points[k] = {batch.rough.x[k] + batch.dx[k] * static_cast<double>(height[k]),
                 batch.rough.y[k] + batch.dy[k] * static_cast<double>(height[k]),
                 batch.rough.z[k] + batch.dz[k] * static_cast<double>(height[k])};
  }
}

void Scan::corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const {
  const std::uint64_t columns = grid_.columns;
  const std::uint64_t last_fan = faces() - columns;
  RowFinder finder(2 * columns);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::uint64_t id = ids[k];
    if (id < columns) {
      corners[k].vertex = {0, 1 + id, id + 1 < columns ? id + 2 : 1};
    } else if (id >= last_fan) {
      const std::uint64_t column = id - last_fan;
      const std::uint64_t ring = 1 + (grid_.rows - 1) * columns;
      corners[k].vertex = {vertices() - 1, ring + (column + 1 < columns ? column + 1 : 0),
                           ring + column};
    } else {
      finder.find(id - columns);
      const std::uint64_t within = id - columns - finder.begin();
      const std::uint64_t column = within / 2;
      const std::uint64_t next = column + 1 < columns ? column + 1 : 0;
      const std::uint64_t above = 1 + finder.row() * columns;
      const std::uint64_t below = above + columns;
      if (within % 2 == 0) {
        corners[k].vertex = {above + column, below + column, below + next};
      } else {
        corners[k].vertex = {above + column, below + next, above + next};
      }
    }
  }
}

}  // namespace

std::unique_ptr<GeneratedSurface> make_scan(const GenerateOptions& options) {
  return std::make_unique<Scan>(options);
}

}  // namespace winnow
