#include "support/clustering.hpp"

#include "base/parallel.hpp"
#include "io/arena.hpp"

#include <algorithm>
#include <bit>
#include <memory>

namespace winnow::test {

namespace {

using Batch = std::unique_ptr<FaceBatch>;

std::vector<Batch> batches_of(const std::vector<Triangle>& faces, const ClusterStyle& style) {
  std::vector<Batch> batches;
  for (std::size_t from = 0; from < faces.size();) {
    const std::size_t most = std::min(FaceBatch::capacity, faces.size() - from);
    auto batch = std::make_unique<FaceBatch>();
    batch->count = style.batches == nullptr ? most : style.batches->between(1, most);
    batch->first = from;
    batch->single = style.single;
    batch->status.fill(FaceStatus::good);
    for (std::size_t i = 0; i < batch->count; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double x = faces[from + i][corner][axis];
          batch->position[corner][axis][i] = style.single ? -1 : x;
          batch->single_position[corner][axis][i] = style.single ? static_cast<float>(x) : -1;
        }
      }
    }
    from += batch->count;
    batches.push_back(std::move(batch));
  }
  if (style.batches != nullptr) style.batches->shuffle(batches);
  return batches;
}

bool same(const IndexedVertex& a, const IndexedVertex& b) {
  bool same = a.key == b.key;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    same = same && std::bit_cast<std::uint64_t>(a.position[axis]) ==
                       std::bit_cast<std::uint64_t>(b.position[axis]);
    same = same && std::bit_cast<std::uint32_t>(a.normal[axis]) ==
                       std::bit_cast<std::uint32_t>(b.normal[axis]);
  }
  return same;
}

}  // namespace

PlainMesh plain(const StoredMesh& mesh) {
  PlainMesh out;
  out.vertices.resize(mesh.vertices->size());
  mesh.vertices->records().read(0, std::as_writable_bytes(std::span(out.vertices)));
  out.faces.resize(mesh.face_count);
  mesh.faces->read(0, std::as_writable_bytes(std::span(out.faces)));
  return out;
}

PlainMesh plain(const ClusterResult& clustered) {
  PlainMesh out = plain(clustered.mesh);
  out.cells = clustered.cells;
  out.turned = clustered.turned;
  out.fused = clustered.fused;
  return out;
}

PlainMesh plain(const WeldResult& welded) {
  PlainMesh out = plain(welded.mesh);
  out.fused = welded.fused;
  out.counts = welded.counts;
  return out;
}

Triangle PlainMesh::triangle(std::size_t face) const {
  const auto& [a, b, c] = faces[face];
  return {vertices.at(a).position, vertices.at(b).position, vertices.at(c).position};
}

namespace {

// Of everything added, what `finish` makes.
template <typename Finish>
auto clustered_by(Job& job, const std::vector<Triangle>& faces, const ClusterSettings& settings,
                  const ClusterStyle& style, const Finish& finish) {
  const std::vector<Batch> batches = batches_of(faces, style);
  return in_arena(job, [&] {
    const auto clusterer = Clusterer::make(job, settings, style.memory);
    constexpr std::size_t at_once = 16;
    for (std::size_t from = 0; from < batches.size(); from += at_once) {
      const std::size_t count = std::min(at_once, batches.size() - from);
      parallel_for(count, [&](std::size_t i) { clusterer->add(*batches[from + i]); });
      if (style.ask_to_spill && clusterer->wants_to_spill()) clusterer->spill();
    }
    return finish(*clusterer);
  });
}

}  // namespace

ClusterResult clustered(Job& job, const std::vector<Triangle>& faces,
                        const ClusterSettings& settings) {
  return clustered_by(job, faces, settings, {},
                      [](Clusterer& clusterer) { return clusterer.finish(); });
}

PlainMesh cluster(const std::vector<Triangle>& faces, const ClusterSettings& settings,
                  const ClusterStyle& style) {
  TestJob test({.threads = style.threads});
  return clustered_by(test.job, faces, settings, style, [&](Clusterer& clusterer) {
    const ClusterCounts counts = clusterer.counts();
    PlainMesh mesh = plain(clusterer.finish());
    mesh.counts = counts;
    mesh.spilled = test.job.scratch.written();
    return mesh;
  });
}

std::string difference(const PlainMesh& a, const PlainMesh& b) {
  if (a.cells != b.cells) return "cells";
  if (a.vertices.size() != b.vertices.size()) return "number of vertices";
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    if (!same(a.vertices[i], b.vertices[i])) return "vertex " + std::to_string(i);
  }
  if (a.faces != b.faces) return "faces";
  if (a.turned != b.turned) return "turned faces";
  if (a.fused != b.fused) return "fused faces";
  return "";
}

ClusterSettings settings_over(const std::vector<Triangle>& faces, double cell,
                              Placement placement) {
  return {Grid::over(box_of(faces), cell), placement, true};
}

}  // namespace winnow::test
