#include "read/gltf/attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace winnow {

namespace {

constexpr std::array<const char*, 4> light_names{"red", "green", "blue", "alpha"};

// Of which each holds all that those before it hold.
NumberType scalar_type(GltfType type) {
  if (type == GltfType::uint8) return NumberType::uint8;
  return type == GltfType::uint16 ? NumberType::uint16 : NumberType::float32;
}

}  // namespace

GltfAttributes attributes_of(const GltfDocument& document) {
  GltfAttributes all;
  std::size_t primitives = 0;
  std::size_t with_normals = 0;
  std::size_t with_colors = 0;
  for (const GltfPlacedMesh& placed : document.placed) {
    for (const GltfPrimitive& primitive : document.meshes[placed.mesh]) {
      ++primitives;
      if (primitive.normals) ++with_normals;
      if (!primitive.colors) continue;
      ++with_colors;
      const GltfAccessor& colors = document.accessors[*primitive.colors];
      all.color_type = std::max(all.color_type, scalar_type(colors.type));
      all.alpha = all.alpha || colors.components == 4;
    }
  }
  all.normals = with_normals > 0 && with_normals == primitives;
  all.colors = with_colors > 0 && with_colors == primitives;
  if (with_normals > 0 && !all.normals) all.unread.emplace_back("normals of some vertices");
  if (with_colors > 0 && !all.colors) all.unread.emplace_back(colors_of_some);
  all.unread.insert(all.unread.end(), document.unread.begin(), document.unread.end());
  return all;
}

AvailableAttributes offer_of(const GltfAttributes& attributes) {
  AvailableAttributes offer;
  for (std::size_t i = 0; i < normal_names.size() && attributes.normals; ++i)
    offer.scalars.push_back({std::string(normal_names[i]), NumberType::float32});
  for (std::size_t i = 0; i < (attributes.alpha ? 4 : 3) && attributes.colors; ++i) {
    offer.scalars.push_back({light_names[i], attributes.color_type,
                             i < 3 ? AttributeKind::light : AttributeKind::value});
  }
  offer.unread = attributes.unread;
  return offer;
}

GltfVertexAttributes::GltfVertexAttributes(GltfBytes& bytes, const GltfDocument& document,
                                           const GltfAttributes& attributes,
                                           const GltfPrimitive& primitive,
                                           const GltfPrimitive::Target& moves,
                                           const std::vector<bool>& carried, const GltfTurn& turn,
                                           const std::string& name)
    : attributes_(attributes),
      carried_(carried),
      turn_(turn),
      first_color_(attributes.normals ? 3 : 0) {
  if (any(0, first_color_))
    normals_.emplace(bytes, document, *primitive.normals, GltfUse::normals, name);
  if (any(first_color_, carried.size()))
    colors_.emplace(bytes, document, *primitive.colors, GltfUse::colors, name);
  if (normals_ && moves.normals)
    normal_moves_.emplace(bytes, document, *moves.normals, GltfUse::vectors, name);
  if (colors_ && moves.colors)
    color_moves_.emplace(bytes, document, *moves.colors, GltfUse::color_moves, name);
}

bool GltfVertexAttributes::any(std::size_t begin, std::size_t end) const {
  return std::any_of(carried_.begin() + static_cast<std::ptrdiff_t>(begin),
                     carried_.begin() + static_cast<std::ptrdiff_t>(end),
                     [](bool one) { return one; });
}

void GltfVertexAttributes::next(std::size_t count, std::vector<double>& out) {
  out.clear();
  if (!normals_ && !colors_) return;
  const std::span<const double> normals = normals_ ? normals_->next() : std::span<const double>();
  const std::span<const double> colors = colors_ ? colors_->next() : std::span<const double>();
  const std::span<const double> more =
      normal_moves_ ? normal_moves_->next() : std::span<const double>();
  if (color_moves_) moves_ = color_moves_->next();
  const double full = full_component(attributes_.color_type);
  for (std::size_t v = 0; v < count; ++v) {
    if (normals_) {
      Point here{normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]};
      if (normal_moves_) here = here + Point{more[3 * v], more[3 * v + 1], more[3 * v + 2]};
      const Point normal = turn_.normal(here);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (carried_[axis]) out.push_back(normal[axis]);
      }
    }
    for (std::size_t i = first_color_; i < carried_.size() && colors_; ++i) {
      if (!carried_[i]) continue;
      const std::size_t component = i - first_color_;
      const std::size_t components = colors_->components();
      const double at_rest = component < components ? colors[components * v + component] : 1;
      out.push_back(moved(v, component, at_rest, full));
    }
  }
}

double GltfVertexAttributes::moved(std::size_t vertex, std::size_t component, double at_rest,
                                   double full) const {
  const std::size_t components = color_moves_ ? color_moves_->components() : 0;
  if (component >= components) return full * at_rest;
  const double now = full * std::clamp(at_rest + moves_[components * vertex + component], 0.0, 1.0);
  return is_integer(attributes_.color_type) ? std::round(now) : now;
}

}  // namespace winnow
