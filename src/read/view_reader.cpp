#include "read/view_reader.hpp"

#include "io/spooled_source.hpp"
#include "read/indexed/reader.hpp"
#include "read/ply/scalar.hpp"
#include "read/view_arrays.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace winnow {

namespace {

InputFacts facts_of(const MeshView& mesh, const AttributeRequest& wish) {
  InputFacts facts;
  facts.format = "memory";
  facts.faces = mesh.faces.count();
  facts.vertices = mesh.positions.count();
  facts.double_positions = mesh.positions.type() == NumberType::float64;
  facts.offer.scalars = attributes_of(mesh);
  facts.choice = choose_attributes(wish, facts.offer, "attributes");
  const std::vector<Attribute>& all = facts.offer.scalars;
  facts.normals = std::all_of(normal_names.begin(), normal_names.end(), [&](std::string_view name) {
    return std::any_of(all.begin(), all.end(), [&](const Attribute& a) { return a.name == name; });
  });
  std::string line = "vertex:";
  for (const Attribute& attribute : all) line += " " + described(attribute);
  if (!all.empty()) facts.attributes.push_back(line);
  return facts;
}

std::uint64_t size_of(const MeshView& mesh) {
  std::uint64_t size = 3 * (mesh.positions.count() * size_of(mesh.positions.type()) +
                            mesh.faces.count() * size_of(mesh.faces.type()));
  for (const MeshView::Attribute& attribute : mesh.attributes)
    size += attribute.values.count() * size_of(attribute.values.type());
  return size;
}

// What the arrays are called in messages about single faces is "faces". There are no bytes.
class ViewReader final : public IndexedReader {
 public:
  ViewReader(Job& job, const MeshView& mesh, const ReaderMemory& memory,
             const AttributeRequest& wish)
      : IndexedReader(job, spooled_source("faces", {}, {}), memory, memory.vertices), mesh_(mesh) {
    facts_ = facts_of(mesh_, wish);
    if (stand_together()) {
      look_up_in_place();
    } else {
      keep_vertices();
    }
  }

  [[nodiscard]] std::uint64_t bytes() const override { return size_of(mesh_); }

 protected:
  void begin_indices() override { next_ = 0; }

  bool next_indices(RawBatch& batch) override {
    const std::uint64_t left = mesh_.faces.count() - next_;
    const std::size_t count = std::min<std::uint64_t>(memory_.batch_faces, left);
    batch.indices.resize(3 * count);
    batch.status.assign(count, FaceStatus::good);
    batch.count = count;
    if (count == 0) return false;
    load_faces(mesh_.faces, next_, count, batch.indices.data());
    next_ += count;
    return true;
  }

  [[nodiscard]] bool faces_come_again() const override { return true; }

 private:
  [[nodiscard]] const Rows<1>& carried(std::size_t number) const {
    return mesh_.attributes[facts_.choice.scalar[number]].values;
  }
  [[nodiscard]] std::size_t carried_count() const { return facts_.choice.scalar.size(); }

  // Whether one stride leads from vertex to vertex in all arrays.
  [[nodiscard]] bool stand_together() const {
    for (std::size_t k = 0; k < carried_count(); ++k) {
      if (carried(k).stride() != mesh_.positions.stride()) return false;
    }
    return true;
  }

  // From the array that lies lowest, wherever the others are.
  void look_up_in_place() {
    const auto place = [](const void* data) { return reinterpret_cast<std::uintptr_t>(data); };
    const void* lowest = mesh_.positions.data();
    for (std::size_t k = 0; k < carried_count(); ++k) {
      if (place(carried(k).data()) < place(lowest)) lowest = carried(k).data();
    }
    const NumberType type = mesh_.positions.type();
    const std::size_t x = place(mesh_.positions.data()) - place(lowest);
    const std::size_t size = size_of(type);
    VertexLayout layout{mesh_.positions.stride(), {x, x + size, x + 2 * size}, {type, type, type}};
    for (std::size_t k = 0; k < carried_count(); ++k) {
      layout.attributes.push_back({place(carried(k).data()) - place(lowest), carried(k).type()});
    }
    vertices_.look_in(static_cast<const std::byte*>(lowest), mesh_.positions.count(), layout);
  }

  void keep_vertices() {
    constexpr std::uint64_t at_once = 4096;
    const Rows<3>& positions = mesh_.positions;
    job_.progress.begin("read vertices", positions.count(), "vertices");
    vertices_.begin_keeping(facts_.double_positions, types_of(facts_.choice.carried));
    const NumberType type = positions.type();
    const auto number = [](const void* data, std::uint64_t offset, NumberType of) {
      return load_real(static_cast<const std::byte*>(data) + offset, of, false);
    };
    std::vector<double> xyz;
    std::vector<double> attributes;
    for (std::uint64_t i = 0; i < positions.count(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        xyz.push_back(
            number(positions.data(), i * positions.stride() + axis * size_of(type), type));
      }
      for (std::size_t k = 0; k < carried_count(); ++k) {
        attributes.push_back(
            number(carried(k).data(), i * carried(k).stride(), facts_.choice.carried[k].type));
      }
      if (xyz.size() < 3 * at_once && i + 1 < positions.count()) continue;
      vertices_.keep(xyz, attributes);
      job_.progress.advance(xyz.size() / 3);
      xyz.clear();
      attributes.clear();
    }
    vertices_.finish_keeping();
  }

  const MeshView& mesh_;
  std::uint64_t next_ = 0;
};

}  // namespace

std::unique_ptr<MeshReader> open_view(Job& job, const MeshView& mesh, const ReaderMemory& memory,
                                      const AttributeRequest& wish) {
  return std::make_unique<ViewReader>(job, mesh, memory, wish);
}

InputProbe look_at_view(const MeshView& mesh, const AttributeRequest& wish) {
  InputProbe probe;
  probe.facts = facts_of(mesh, wish);
  probe.bytes = size_of(mesh);
  return probe;
}

}  // namespace winnow
