#include "sequence/frame_attributes.hpp"

#include "io/spool_records.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

constexpr std::size_t none = SIZE_MAX;

bool is_light(const Attribute& attribute) {
  return attribute.kind == AttributeKind::light;
}

bool is_normal(const Attribute& attribute) {
  return attribute.kind == AttributeKind::normal;
}

}  // namespace

void FrameAttributes::begin_first(MeshReader& reader, const Settle& settle) {
  attributes_ = reader.facts().choice.carried;
  if (attributes_.empty() || !reader.facts().vertices) return attributes_.clear();
  settle(attributes_, reader.attribute_ranges());
  lacking_.resize(attributes_.size());
  begin_later(reader, {});
}

void FrameAttributes::begin_frame(std::uint64_t vertices) {
  vertices_ = vertices;
  frame_.resize(vertices * count());
}

void FrameAttributes::begin_later(const MeshReader& reader, const std::string& frame) {
  const std::vector<Attribute>& here = reader.facts().choice.carried;
  in_reader_.assign(count(), none);
  for (std::size_t k = 0; k < count(); ++k) {
    const auto found = std::find_if(here.begin(), here.end(), [&](const Attribute& attribute) {
      return attribute.name == attributes_[k].name && attribute.type == attributes_[k].type &&
             is_light(attribute) == is_light(attributes_[k]);
    });
    if (found != here.end()) {
      in_reader_[k] = static_cast<std::size_t>(found - here.begin());
    } else if (lacking_[k].empty()) {
      lacking_[k] = frame;
    }
  }
}

void FrameAttributes::take(const MeshReader& reader, const PositionView& view,
                           const std::uint32_t* place) {
  if (count() == 0) return;
  const std::size_t offered = reader.facts().choice.carried.size();
  std::vector<double> values;
  if (offered > 0) reader.read_attributes(view, values);
  for (std::size_t i = 0; i < view.count; ++i) {
    const std::uint64_t v = view.first + i;
    double* const to = frame_.data() + (place != nullptr ? place[v] : v) * count();
    for (std::size_t k = 0; k < count(); ++k) {
      to[k] = 0;
      if (in_reader_[k] == none) continue;
      const double stored = values[i * offered + in_reader_[k]];
      if (std::isfinite(stored)) {
        to[k] = mean_of_stored(attributes_[k], stored);
      } else {
        ++not_finite_;
      }
    }
  }
}

void FrameAttributes::put_in_order(const VertexOrder& order) {
  if (count() == 0) return;
  std::vector<double> in_order(frame_.size());
  for (std::size_t v = 0; v < vertices_; ++v)
    std::copy_n(frame_.data() + v * count(), count(), in_order.data() + order.place[v] * count());
  frame_ = std::move(in_order);
}

void FrameAttributes::keep_frame() {
  if (count() > 0) values_.append(std::as_bytes(std::span(frame_)));
}

void FrameAttributes::finish(std::vector<std::string>& dropped) {
  values_.finish();
  frame_ = {};
  std::string lacking_normals;
  for (std::size_t k = 0; k < count(); ++k) {
    if (is_normal(attributes_[k]) && lacking_normals.empty()) lacking_normals = lacking_[k];
  }
  for (std::size_t k = 0; k < count(); ++k) {
    if (is_normal(attributes_[k])) lacking_[k] = lacking_normals;
    if (lacking_[k].empty()) {
      carried_.push_back(attributes_[k]);
      number_.push_back(k);
    } else {
      dropped.push_back(described(attributes_[k]) + ", which " + lacking_[k] + " lacks");
    }
  }
}

std::vector<double> FrameAttributes::read(std::size_t frame, std::size_t first,
                                          std::size_t vertices) const {
  const std::vector<double> all =
      read_records<double>(values_, (frame * vertices_ + first) * count(), vertices * count());
  std::vector<double> out;
  out.reserve(vertices * number_.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    for (const std::size_t k : number_) out.push_back(all[v * count() + k]);
  }
  return out;
}

}  // namespace winnow
