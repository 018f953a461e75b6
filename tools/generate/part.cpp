// A closed surface like a machined part: a plate with a pocket, a hole, thin fins, a rib and a thin
// wall. Flat faces are flat to the last bit.
#include "generate/blocks.hpp"
#include "generate/patches.hpp"
#include "generate/row_grid.hpp"
#include "generate/seed_stream.hpp"
#include "generate/surface.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace winnow {

namespace {

// Planes whose gaps have lengths in the given ranges, scaled to `extent` and centred on 0.
std::vector<double> lay_planes(SeedStream& random, const std::vector<std::array<double, 2>>& gaps,
                               double extent) {
  std::vector<double> planes{0};
  for (const auto& [least, most] : gaps)
    planes.push_back(planes.back() + random.between(least, most));
  const double scale = extent / planes.back();
  for (double& plane : planes) plane = plane * scale - extent / 2;
  return planes;
}

Blocks build(std::uint32_t seed) {
  SeedStream random(std::uint64_t{seed} + (std::uint64_t{3} << 32));
  const std::uint32_t fins = 3 + random.bits() % 3;
  // x: thin wall, web, hole, web, pocket, web, then fins and the spaces behind them.
  std::vector<std::array<double, 2>> x{{0.02, 0.03}, {0.10, 0.15}, {0.15, 0.25},
                                       {0.10, 0.15}, {0.30, 0.50}, {0.10, 0.15}};
  for (std::uint32_t fin = 0; fin < fins; ++fin) {
    x.push_back({0.012, 0.030});
    x.push_back({0.10, 0.18});
  }
  const std::vector<std::array<double, 2>> y{
      {0.10, 0.20}, {0.30, 0.45}, {0.02, 0.20}, {0.30, 0.45}, {0.10, 0.20}};
  const std::vector<std::array<double, 2>> z{
      {0.04, 0.08}, {0.12, 0.20}, {0.15, 0.25}, {0.15, 0.40}};
  Blocks blocks(
      {lay_planes(random, x, 2.0), lay_planes(random, y, 1.3), lay_planes(random, z, 0.7)});

  const std::uint32_t width = blocks.gaps(0);
  const std::uint32_t depth = blocks.gaps(1);
  constexpr std::uint32_t first_fin = 6;
  blocks.set({0, 0, 0}, {width, depth, 2}, true);  // plate
  blocks.set({0, 0, 2}, {1, depth, 4}, true);      // thin wall along one side
  blocks.set({0, 2, 3}, {1, 3, 4}, false);         // notch in it
  blocks.set({2, 1, 0}, {3, 2, 2}, false);         // hole through the plate
  blocks.set({4, 1, 1}, {5, 4, 2}, false);         // pocket with a thin floor
  for (std::uint32_t fin = 0; fin < fins; ++fin) {
    const std::uint32_t at = first_fin + 2 * fin;
    blocks.set({at, 1, 2}, {at + 1, 4, 4}, true);
  }
  blocks.set({first_fin, 2, 2}, {width - 1, 3, 3}, true);  // rib across the fins
  return blocks;
}

class Part final : public GeneratedSurface {
 public:
  explicit Part(const GenerateOptions& options) {
    const Blocks blocks = build(options.seed);
    table_ = number_patches(blocks, choose_pieces(blocks, options.faces / 2));
  }

  [[nodiscard]] std::uint64_t vertices() const override { return table_.vertices; }
  [[nodiscard]] std::uint64_t faces() const override { return table_.faces; }

  void positions(std::span<const std::uint64_t> ids, std::span<Point> points) const override;
  void corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const override;

 private:
  Patches table_;
};

// The last entry of a table that begins at `id` or before it.
template <typename Entry>
const Entry& entry_of(const std::vector<Entry>& table, std::uint64_t id) {
  return *std::prev(std::upper_bound(
      table.begin(), table.end(), id,
      [](std::uint64_t wanted, const Entry& entry) { return wanted < entry.begin; }));
}

void Part::positions(std::span<const std::uint64_t> ids, std::span<Point> points) const {
  for (std::size_t k = 0; k < ids.size();) {
    const Patch& patch = entry_of(table_.patches, ids[k]);
    const bool is_last = &patch == &table_.patches.back();
    const std::uint64_t end = is_last ? table_.vertices : (&patch + 1)->begin;
    RowFinder finder(patch.row);
    for (; k < ids.size() && ids[k] - patch.begin < end - patch.begin; ++k) {
      const std::uint64_t number = ids[k] - patch.begin;
      finder.find(number);
      points[k] = patch.origin;
      points[k][patch.axis[0]] += patch.step[0] * static_cast<double>(number - finder.begin());
      points[k][patch.axis[1]] += patch.step[1] * static_cast<double>(finder.row());
    }
  }
}

void Part::corners(std::span<const std::uint64_t> ids, std::span<MeshFace> corners) const {
  for (std::size_t k = 0; k < ids.size();) {
    const Sheet& sheet = entry_of(table_.sheets, ids[k]);
    const std::uint64_t faces = 2 * sheet.pieces[0] * sheet.pieces[1];
    RowFinder finder(2 * sheet.pieces[0]);
    for (; k < ids.size() && ids[k] - sheet.begin < faces; ++k) {
      const std::uint64_t number = ids[k] - sheet.begin;
      finder.find(number);
      const std::uint64_t b = (number - finder.begin()) / 2;
      const std::uint64_t c = finder.row();
      std::array<std::uint64_t, 3>& vertex = corners[k].vertex;
      if (number % 2 == 0) {
        vertex = {sheet.vertex(b, c), sheet.vertex(b + 1, c), sheet.vertex(b + 1, c + 1)};
      } else {
        vertex = {sheet.vertex(b, c), sheet.vertex(b + 1, c + 1), sheet.vertex(b, c + 1)};
      }
      if (!sheet.upwards) std::swap(vertex[1], vertex[2]);
    }
  }
}

}  // namespace

std::unique_ptr<GeneratedSurface> make_part(const GenerateOptions& options) {
  return std::make_unique<Part>(options);
}

}  // namespace winnow
