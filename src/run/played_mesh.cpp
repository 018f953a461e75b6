#include "run/played_mesh.hpp"

#include "base/memory_shares.hpp"
#include "cluster/weld_lattice.hpp"
#include "progressive/look_ahead.hpp"
#include "run/attributes.hpp"
#include "run/write_mesh.hpp"
#include "stitch/round_output.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace winnow {

namespace {

constexpr std::size_t vertices_at_once = 4096;
constexpr std::uint32_t faces_at_once = 4096;
// In any order: each may be on another page, and so may its faces.
constexpr std::size_t scattered_at_once = 64;
// Of one vertex: more are counted.
constexpr std::size_t many_faces = 4096;

// Of keys in the box, whose lattice has twice its side; those of others are not below.
constexpr unsigned ranked_bits = 32, low_bits = 3 * (axis_bits - 1) - ranked_bits;
constexpr std::uint64_t highest_rank = (std::uint64_t{1} << ranked_bits) - 1;

std::uint64_t rank_of(CellKey key) {
  return std::min(key >> low_bits, highest_rank);
}

// By their high 32 bits, and of equal ones as they were. `each_part` is called now and then.
template <typename EachPart>
void sort_by_rank(std::pmr::vector<std::uint64_t>& items, std::pmr::vector<std::uint64_t>& other,
                  const EachPart& each_part) {
  constexpr unsigned digit_bits = 8, digits = ranked_bits / digit_bits, first = 64 - ranked_bits;
  constexpr std::size_t values = std::size_t{1} << digit_bits;
  const auto digit = [](std::uint64_t item, unsigned k) {
    return item >> (first + k * digit_bits) & (values - 1);
  };
  std::array<std::array<std::size_t, values>, digits> place{};
  for (const std::uint64_t item : items) {
    for (unsigned k = 0; k < digits; ++k) ++place[k][digit(item, k)];
  }
  for (unsigned k = 0; k < digits; ++k) {
    std::exclusive_scan(place[k].begin(), place[k].end(), place[k].begin(), std::size_t{0});
    for (std::size_t i = 0; i < items.size(); ++i) {
      other[place[k][digit(items[i], k)]++] = items[i];
      if (i % vertices_at_once == 0) each_part();
    }
    items.swap(other);
  }
}

}  // namespace

PlayedMesh::PlayedMesh(Job& job, const SplitPlayer& player, std::vector<std::size_t> carried,
                       bool normals, ScratchMemory* scratch)
    : job_(job),
      player_(player),
      mesh_(player.mesh()),
      carried_(std::move(carried)),
      scratch_(scratch),
      reserved_(job.budget.reserve(scratch == nullptr ? memory(mesh_.vertices(), normals) : 0,
                                   "ordering so many faces")),
      lattice_(lattice_over(player.header().box)),
      order_(pool()),
      number_(pool()),
      normal_(pool()) {
  order_vertices();
  if (normals) sum_normals();
}

std::uint64_t PlayedMesh::memory(std::uint64_t vertices, bool normals) {
  return vertices * (2 * sizeof(Ranked) + sizeof(std::uint32_t) + (normals ? sizeof(Point) : 0));
}

std::pmr::memory_resource* PlayedMesh::pool() const {
  return scratch_ != nullptr ? scratch_ : std::pmr::get_default_resource();
}

// Every few thousand steps.
void PlayedMesh::turn() const {
  job_.progress.check_cancelled();
  if (scratch_ != nullptr) scratch_->give_back();
}

CellKey PlayedMesh::key(std::uint32_t v) const {
  return key_of(lattice_, position(v));
}

void PlayedMesh::order_vertices() {
  order_.reserve(mesh_.vertices());
  for (std::uint32_t v = 0; v < mesh_.vertices(); ++v) {
    if (mesh_.has_faces(v)) order_.push_back(rank_of(key(v)) << 32 | v);
    if (v % vertices_at_once == 0) turn();
  }
  {
    std::pmr::vector<Ranked> other(order_.size(), pool());
    sort_by_rank(order_, other, [this] { turn(); });
  }
  order_alike();
  number_.assign(mesh_.vertices(), no_number);
  for (std::uint32_t i = 0; i < order_.size(); ++i) {
    number_[vertex(i)] = i;
    if (i % scattered_at_once == 0) turn();
  }
}

// Those that only the low bits of their keys tell apart.
void PlayedMesh::order_alike() {
  const auto rank = [](Ranked item) { return item >> 32; };
  std::uint32_t compared = 0;
  for (auto begin = order_.begin(); begin != order_.end();) {
    const std::uint64_t mine = rank(*begin);
    auto end = begin + 1;
    while (end != order_.end() && rank(*end) == mine) ++end;
    if (end - begin > 1 && mine == highest_rank) {
      std::sort(begin, end, [&](Ranked a, Ranked b) {
        if (++compared % scattered_at_once == 0) turn();
        const auto v = static_cast<std::uint32_t>(a), w = static_cast<std::uint32_t>(b);
        const CellKey first = key(v), second = key(w);
        return first != second ? first < second : v < w;
      });
    } else if (end - begin > 1) {
      for (auto at = begin; at != end; ++at) {
        const auto v = static_cast<std::uint32_t>(*at);
        *at = (key(v) & ((CellKey{1} << low_bits) - 1)) << 32 | v;
        if (++compared % scattered_at_once == 0) turn();
      }
      std::sort(begin, end);
    }
    begin = end;
  }
}

void PlayedMesh::sum_normals() {
  normal_.assign(mesh_.vertices(), Point{});
  for (std::uint32_t f = 0; f < mesh_.faces(); ++f) {
    const FaceVertices& face = mesh_.face(f);
    const Point area = doubled_area({position(face[0]), position(face[1]), position(face[2])});
    for (const std::uint32_t v : face) normal_[v] = normal_[v] + area;
    if (f % faces_at_once == 0) turn();
  }
}

// Each is told of where its lowest vertex is.
class PlayedMesh::Faces final : public FaceStream {
 public:
  explicit Faces(const PlayedMesh& played)
      : played_(played), mesh_(played.mesh_), others_(16, played.pool()) {}

  [[nodiscard]] std::vector<std::uint32_t> next(std::size_t count) override {
    std::vector<std::uint32_t> out;
    out.reserve(3 * count);
    while (out.size() < 3 * count) {
      if (told_ == count_ && !gather()) break;
      const std::uint64_t others = others_[told_++];
      out.push_back(place_ - 1);
      out.push_back(static_cast<std::uint32_t>(others >> 32));
      out.push_back(static_cast<std::uint32_t>(others));
    }
    return out;
  }

 private:
  // The faces of the next vertex that is the lowest of one.
  bool gather() {
    told_ = count_ = 0;
    while (count_ == 0) {
      if (place_ == played_.order_.size()) return false;
      if (place_ % scattered_at_once == 0) played_.turn();
      ahead_.go_to(mesh_, place_, played_.order_.size(),
                   [this](std::size_t place) { return played_.vertex(place); });
      mesh_.for_each_face_at(played_.vertex(place_), [&](const FarEdge& far) {
        const std::uint32_t b = played_.number_[far[0]], c = played_.number_[far[1]];
        if (count_ == others_.size()) make_room();
        // Without a branch: any corner is as often the lowest.
        others_[count_] = std::uint64_t{b} << 32 | c;
        count_ += place_ < std::min(b, c) ? 1 : 0;
      });
      ++place_;
    }
    std::sort(others_.begin(), others_.begin() + static_cast<std::ptrdiff_t>(count_));
    return true;
  }
  void make_room() {
    const std::size_t size = 2 * others_.size();
    if (size > many_faces && played_.scratch_ == nullptr)
      reserved_ = played_.job_.budget.reserve(size * sizeof(std::uint64_t), "so many faces");
    others_.resize(size);
  }

  const PlayedMesh& played_;
  const SplitMesh& mesh_;
  std::uint32_t place_ = 0;
  // Of the vertex before, the other two corners of its faces.
  std::pmr::vector<std::uint64_t> others_;
  Reservation reserved_;
  std::size_t count_ = 0, told_ = 0;
  LookAhead ahead_;
};

std::unique_ptr<FaceStream> PlayedMesh::faces() const {
  return std::make_unique<Faces>(*this);
}

Box PlayedMesh::box(Job& job) const {
  Box box;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    box.add(position(vertex(i)));
    if (i % vertices_at_once == 0) job.progress.check_cancelled();
  }
  return box;
}

IndexedVertex PlayedMesh::indexed(std::size_t place) const {
  const std::uint32_t v = vertex(place);
  return {0, position(v), normal_.empty() ? std::array<float, 3>{} : normal_along(normal_[v]), 0};
}

void PlayedMesh::take_values(std::size_t place, std::span<double> means,
                             std::span<double> values) const {
  player_.words().means(mesh_.words(vertex(place)), means);
  for (std::size_t i = 0; i < carried_.size(); ++i) values[i] = means[carried_[i]];
}

FinishedVertices PlayedMesh::vertices(const MeshShape& shape, std::uint64_t first,
                                      std::size_t count) const {
  FinishedVertices out;
  out.vertices.reserve(count);
  out.attributes.resize(carried_.size() * count);
  std::vector<double> means(player_.header().attributes.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i % scattered_at_once == 0) turn();
    out.vertices.push_back(finished(indexed(first + i)));
    if (carried_.empty()) continue;
    const std::span<double> values =
        std::span(out.attributes).subspan(i * carried_.size(), carried_.size());
    take_values(first + i, means, values);
    finish_attributes(shape, values, out.vertices.back());
  }
  return out;
}

StoredMesh PlayedMesh::store() const {
  StoredMesh out(job_, {0, carried_.size()},
                 MeshMemory::divide(share::left::added_mesh(job_.budget.left())));
  std::vector<IndexedVertex> vertices;
  std::vector<double> means(player_.header().attributes.size());
  std::vector<double> values(carried_.size()), numbers;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    vertices.push_back(indexed(i));
    vertices.back().key = key_of(lattice_, vertices.back().position);
    if (!carried_.empty()) take_values(i, means, values);
    numbers.insert(numbers.end(), values.begin(), values.end());
    if (i % scattered_at_once == 0) turn();
    if (vertices.size() < vertices_at_once && i + 1 < order_.size()) continue;
    out.append_vertices(vertices, {}, numbers);
    vertices.clear();
    numbers.clear();
  }
  out.finish_vertices();
  Faces stream(*this);
  for (std::vector<std::uint32_t> corners; !(corners = stream.next(faces_at_once)).empty();)
    out.append_faces({reinterpret_cast<const FaceVertices*>(corners.data()), corners.size() / 3});
  out.finish_faces();
  return out;
}

const StoredMesh& PlayedMesh::stored() const {
  if (!stored_) stored_.emplace(store());
  return *stored_;
}

}  // namespace winnow
