#include "read/gltf/instances.hpp"

#include <winnow/error.hpp>

#include <algorithm>
#include <span>

namespace winnow {

GltfInstanceReader::GltfInstanceReader(GltfBytes& bytes, const GltfDocument& document,
                                       const GltfInstances& instances, const std::string& name) {
  std::optional<std::uint64_t> count;
  const auto open = [&](std::optional<std::size_t> accessor, GltfUse use,
                        std::optional<GltfElements>& into) {
    if (!accessor) return;
    const std::uint64_t here = document.accessors[*accessor].count;
    if (count.value_or(here) != here) {
      throw Error(ErrorKind::bad_input,
                  "'" + name +
                      "': the accessors of EXT_mesh_gpu_instancing differ in length; "
                      "the file is damaged, or was written by a program that is wrong");
    }
    count = here;
    into.emplace(bytes, document, *accessor, use, name);
  };
  open(instances.translations, GltfUse::vectors, translations_);
  open(instances.rotations, GltfUse::rotations, rotations_);
  open(instances.scales, GltfUse::vectors, scales_);
}

std::vector<GltfTransform> GltfInstanceReader::next() {
  const auto part = [](std::optional<GltfElements>& elements) {
    return elements ? elements->next() : std::span<const double>();
  };
  const std::span<const double> moved = part(translations_);
  const std::span<const double> turned = part(rotations_);
  const std::span<const double> scaled = part(scales_);
  std::vector<GltfTransform> instances(
      std::max({moved.size() / 3, turned.size() / 4, scaled.size() / 3}));
  const auto vector_at = [](std::span<const double> values, std::size_t i, double usual) {
    if (values.empty()) return Point{usual, usual, usual};
    return Point{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  };
  for (std::size_t i = 0; i < instances.size(); ++i) {
    std::array<double, 4> rotation{0, 0, 0, 1};
    if (!turned.empty())
      std::copy_n(turned.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, rotation.begin());
    instances[i] = gltf_transform(vector_at(moved, i, 0), rotation, vector_at(scaled, i, 1));
  }
  return instances;
}

}  // namespace winnow
