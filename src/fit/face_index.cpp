#include "fit/face_index.hpp"

#include "base/closest_point.hpp"
#include "base/instruction_set.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winnow {

namespace {

// Boxes of pages overlap: a thread that has fewer of them reads them again and again.
constexpr std::size_t least_slots = 16;
constexpr std::size_t most_slots = 64;
// Faces of a page where all are in memory: trees of many faces overlap less. Where they are not,
// few are read at once.
constexpr std::uint64_t large_page = std::uint64_t{1} << 14;
constexpr std::uint64_t small_page = 512;

// Fewer points are looked for one by one, and so are those with more faces around them.
constexpr std::size_t least_at_once = 4;
constexpr std::size_t at_once_alone = 64;
// Points are mostly no farther from their faces than the last ones, times this.
constexpr double usual_growth = 1.25;
constexpr std::size_t most_around(std::size_t points) {
  return 32 + 2 * points;
}
constexpr std::size_t most_candidates = 2 * most_around(PointGroup::capacity);
// No more boxes of faces may be as near to a point as its nearest face. Where points are looked for
// at once there are never so many.
constexpr std::size_t most_near = 256;
static_assert(most_near >= most_candidates);
// No more than floats have room for when lengths are multiplied with each other.
constexpr double farthest_seen = 1e16;
// Distances by floats are off by less than this part of all lengths that come in.
constexpr double rounding = 64 * 0x1p-24;
// The square of what is nothing but rounding beside 1.
constexpr double line = 1e-20;
// Faces that tell how long faces are.
constexpr std::uint64_t measured_faces = 64;

std::uint64_t pages_of(std::uint64_t faces, std::uint64_t page) {
  return (faces + page - 1) / page;
}

double squared_distance(const Point& point, const Box& box) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double off = std::max({box.low[axis] - point[axis], point[axis] - box.high[axis], 0.0});
    squared += off * off;
  }
  return squared;
}

Box box_of(const Triangle& t) {
  Box box;
  for (const Point& corner : t) box.add(corner);
  return box;
}

// As long as 1 and across `along`, in the plane of the vector `c` where it has a plane.
Point across_of(const Point& along, const Point& c) {
  const Point off = c - dot(along, c) * along;
  if (dot(off, off) > line * dot(c, c)) {
    const Point across = unit(off);
    return unit(across - dot(along, across) * along);
  }
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(along[i]) < std::abs(along[axis])) axis = i;
  }
  Point other{};
  other[axis] = 1;
  return unit(cross(along, other));
}

}  // namespace

FlatFace flat_face(const Triangle& t, double scale) {
  const Point b = scale * (t[1] - t[0]);
  const Point c = scale * (t[2] - t[0]);
  Point along = unit(b);
  if (!(dot(along, along) > 0)) along = unit(c);
  if (!(dot(along, along) > 0)) along = {1, 0, 0};
  const Point across = across_of(along, c);
  const Point up = cross(along, across);
  const auto one_by = [](double x, double y) {
    const auto part = static_cast<float>(1 / (x * x + y * y));
    return std::isfinite(part) ? part : 0.0F;
  };
  FlatFace face;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    face.along[axis] = static_cast<float>(along[axis]);
    face.across[axis] = static_cast<float>(across[axis]);
    face.up[axis] = static_cast<float>(up[axis]);
  }
  const double second = dot(along, b);
  const double x = dot(along, c);
  const double y = dot(across, c);
  face.second = static_cast<float>(second);
  face.third[0] = static_cast<float>(x);
  face.third[1] = static_cast<float>(y);
  face.side = static_cast<float>(x - second);
  face.by_first_side = one_by(x, y);
  face.by_second_side = one_by(x - second, y);
  face.reach = static_cast<float>(std::max(length(b), length(c)));
  return face;
}

constexpr std::uint64_t FaceIndex::page_bytes(std::uint64_t faces) {
  return faces * (sizeof(Triangle) + sizeof(FlatFace)) + BoxTree::memory_made(faces);
}

constexpr std::uint64_t FaceIndex::making_bytes(std::uint64_t faces) {
  return faces * (sizeof(Triangle) + sizeof(FlatFace) + sizeof(Box)) + BoxTree::memory(faces);
}

FaceIndex::FaceIndex(Job& job, const StoredMesh& mesh, std::uint64_t memory)
    : job_(job),
      mesh_(mesh),
      scale_(usual_scale()),
      kernel_(best_kernel(WINNOW_KERNELS(near_kernel))) {
  const auto top = [&](std::uint64_t page) {
    const std::uint64_t pages = pages_of(mesh.face_count, page);
    return pages * sizeof(Box) + BoxTree::memory(pages);
  };
  const std::uint64_t page = std::min(large_page, mesh.face_count);
  const std::uint64_t all = top(large_page) + page_bytes(mesh.face_count) +
                            pages_of(mesh.face_count, large_page) * page_bytes(0) +
                            job.threads * making_bytes(page);
  if (all <= memory) reserved_ = job.budget.try_reserve(all);
  page_faces_ = reserved_ ? large_page : small_page;
  boxes_.resize(pages_of(mesh.face_count, page_faces_));
  if (reserved_) {
    resident_.resize(boxes_.size());
  } else {
    const std::uint64_t slot = job.threads * making_bytes(small_page);
    slots_a_thread_ = std::clamp<std::uint64_t>(memory / slot, least_slots, most_slots);
    reserved_ = job.budget.reserve(top(small_page) + (slots_a_thread_ + 1) * slot,
                                   "looking for near faces");
  }
  struct Item {
    std::size_t number = 0;
    Page page;
  };
  std::size_t next = 0;
  // In order, so that the sum of areas is the same whatever the threads.
  pipeline<Item>(
      job.threads,
      [&](Item& item) {
        item.number = next++;
        return item.number < boxes_.size();
      },
      [&](Item& item) {
        job.progress.check_cancelled();
        VertexIndex::Reader vertices(*mesh.vertices);
        load(item.number, vertices, item.page);
      },
      [&](Item& item) {
        boxes_[item.number] = item.page.tree->whole();
        area_ += item.page.area;
        if (in_memory()) resident_[item.number] = std::move(item.page);
        item.page = {};
      });
  tree_.emplace(boxes_);
}

double FaceIndex::usual_scale() const {
  VertexIndex::Reader vertices(*mesh_.vertices);
  double longest = 0;
  const std::uint64_t step = mesh_.face_count / measured_faces + 1;
  for (std::uint64_t f = 0; f < mesh_.face_count; f += step) {
    const FaceVertices face = mesh_.face(f);
    const Point side = vertices.position(face[1]) - vertices.position(face[0]);
    for (const double x : side) longest = std::max(longest, std::abs(x));
  }
  return longest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(longest), -1000, 1000)) : 1;
}

void FaceIndex::load(std::size_t number, VertexIndex::Reader& vertices, Page& page) const {
  const std::uint64_t first = number * page_faces_;
  const std::uint64_t count = std::min(page_faces_, mesh_.face_count - first);
  std::vector<Box> boxes;
  boxes.reserve(count);
  page.faces.clear();
  page.faces.reserve(count);
  page.flat.clear();
  page.flat.reserve(count);
  page.area = 0;
  for (const auto& [a, b, c] : mesh_.read_faces(first, count)) {
    const Triangle& t = page.faces.emplace_back(
        Triangle{vertices.position(a), vertices.position(b), vertices.position(c)});
    boxes.push_back(box_of(t));
    page.flat.push_back(flat_face(t, scale_));
    page.area += length(doubled_area(t)) / 2;
  }
  page.tree.emplace(boxes);
}

std::size_t FaceIndex::page_near(const Point& point) const {
  double least = std::numeric_limits<double>::max();
  std::size_t near = 0;
  tree_->for_each_within(point, least, [&](std::size_t number) {
    const double squared = squared_distance(point, boxes_[number]);
    if (squared >= least) return;
    least = squared > 0 ? squared : -1;
    near = number;
  });
  return near;
}

FaceIndex::Reader::Reader(const FaceIndex& index)
    : index_(index), vertices_(*index.mesh_.vertices), slots_(index.slots_a_thread_) {
  last_.corner = page(0).faces.front();
}

const FaceIndex::Page& FaceIndex::Reader::page(std::size_t number) {
  if (index_.in_memory()) return index_.resident_[number];
  ++turn_;
  Slot* oldest = &slots_.front();
  for (Slot& slot : slots_) {
    if (slot.number == number) {
      slot.used = turn_;
      return slot.page;
    }
    if (slot.used < oldest->used) oldest = &slot;
  }
  oldest->number = SIZE_MAX;  // should reading fail
  index_.load(number, vertices_, oldest->page);
  oldest->number = number;
  oldest->used = turn_;
  return oldest->page;
}

void FaceIndex::Reader::nearest(std::span<const Point> points, std::vector<Nearest>& out) {
  out.clear();
  while (!points.empty()) {
    std::size_t count = std::min(points.size(), at_once_);
    if (count >= least_at_once && look_around(points.first(count), out)) {
      at_once_ = std::min(2 * at_once_, PointGroup::capacity);
    } else if (count >= 2 * least_at_once) {
      at_once_ = count / 2;
      continue;
    } else {
      count = std::min(points.size(), at_once_alone);
      for (const Point& point : points.first(count)) out.push_back(nearest(point));
    }
    points = points.subspan(count);
  }
}

bool FaceIndex::Reader::look_around(std::span<const Point> points, std::vector<Nearest>& out) {
  Box box;
  for (const Point& point : points) box.add(point);
  const Point middle = 0.5 * box.low + 0.5 * box.high;
  const double scale = index_.scale_;
  double size = scale * box.diagonal();
  const std::size_t lanes =
      (points.size() + PointGroup::lanes - 1) / PointGroup::lanes * PointGroup::lanes;
  for (std::size_t i = 0; i < lanes; ++i) {
    const Point& point = points[std::min(i, points.size() - 1)];
    for (std::size_t axis = 0; axis < 3; ++axis)
      group_.place[axis][i] = static_cast<float>(scale * (point[axis] - middle[axis]));
    group_.least[i] = std::numeric_limits<float>::max();
    group_.next[i] = std::numeric_limits<float>::max();
    group_.nearest[i] = 0;
  }
  // First the faces around the points, as far as the last ones were from theirs; and then those no
  // farther than these, if that was too near.
  candidates_.clear();
  beside_.clear();
  const double margin = std::exchange(margin_, 0);
  double limit = margin * margin;
  double reach = 0;
  const auto collect = [&](std::size_t most, double beyond) {
    index_.tree_->for_each_within(box, limit, [&](std::size_t number) {
      const Page& page = this->page(number);
      const std::uint64_t first = number * index_.page_faces_;
      const auto take = [&](std::size_t place) {
        if (candidates_.size() == most) limit = -1;
        if (limit < 0) return;
        const Triangle& corner = page.faces[place];
        candidates_.push_back({first + place, corner});
        FaceBeside& beside = beside_.emplace_back();
        beside.face = page.flat[place];
        double off = double{beside.face.reach};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double seen = scale * (corner[0][axis] - middle[axis]);
          beside.corner[axis] = static_cast<float>(seen);
          off += std::abs(seen);
        }
        if (!(off <= reach)) reach = off;
      };
      page.tree->for_each_within(box, limit, take, beyond);
    });
    return limit >= 0 && size + reach < farthest_seen;
  };
  if (!collect(most_around(points.size()), -1)) return false;
  if (candidates_.empty()) {
    // The points are all on one side.
    limit = length(box.high - box.low) / 2 + std::sqrt(nearest(middle).squared);
    limit *= limit;
    if (!collect(most_around(points.size()), -1) || candidates_.empty()) return false;
  }
  const float most = index_.kernel_(group_, lanes, beside_.data(), beside_.size(), 0);
  if (!(most < std::numeric_limits<float>::max())) return false;
  const double far = (std::sqrt(double{most}) + rounding * (size + reach)) / scale;
  const double seen = std::exchange(limit, far * far);
  if (limit > seen) {
    const std::size_t around = beside_.size();
    if (!collect(most_candidates, seen)) return false;
    index_.kernel_(group_, lanes, beside_.data() + around, beside_.size() - around,
                   static_cast<std::int32_t>(around));
  }
  margin_ = std::min(usual_growth * far, box.diagonal() / 2);
  size += reach;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float least = group_.least[i];
    // As near as the nearest one except for rounding?
    const double as_near = std::sqrt(double{least}) + 2 * rounding * size;
    if (!(double{group_.next[i]} > as_near * as_near)) {
      out.push_back(nearest_candidate(points[i]));
      continue;
    }
    const auto& [face, corner] = candidates_[static_cast<std::size_t>(group_.nearest[i])];
    const Point here = closest_point(points[i], corner);
    const Point off = points[i] - here;
    out.push_back({face, corner, here, dot(off, off)});
  }
  last_ = out.back();
  return true;
}

const FaceIndex::Nearest& FaceIndex::Reader::nearest_candidate(const Point& point) {
  last_.squared = std::numeric_limits<double>::infinity();
  for (const auto& [face, corner] : candidates_) take_nearer(point, face, corner);
  return last_;
}

void FaceIndex::Reader::take_nearer(const Point& point, std::uint64_t face,
                                    const Triangle& corner) {
  const Point here = closest_point(point, corner);
  const double squared = dot(point - here, point - here);
  if (squared > last_.squared || (squared == last_.squared && face >= last_.face)) return;
  last_ = {face, corner, here, squared};
}

const FaceIndex::Nearest& FaceIndex::Reader::nearest(const Point& point) {
  // Points that follow each other are mostly close, so the last face is near.
  last_.place = closest_point(point, last_.corner);
  last_.squared = dot(point - last_.place, point - last_.place);
  std::size_t looks = 0;
  double limit = last_.squared;
  index_.tree_->for_each_within(point, limit, [&](std::size_t number) {
    const Page& faces = page(number);
    const std::uint64_t first = number * index_.page_faces_;
    faces.tree->for_each_within(point, limit, [&](std::size_t place) {
      if (looks++ == most_near) limit = -1;
      if (limit < 0) return;
      take_nearer(point, first + place, faces.faces[place]);
      limit = last_.squared;
    });
  });
  // In the order of boxes there may be fewer.
  if (looks > most_near && !look_into_nearest_boxes(point))
    last_.squared = std::numeric_limits<double>::infinity();
  return last_;
}

bool FaceIndex::Reader::look_into_nearest_boxes(const Point& point) {
  boxes_.clear();
  double limit = std::numeric_limits<double>::max();
  index_.tree_->for_each_within(point, limit, [&](std::size_t number) {
    const Page& faces = page(number);
    const std::uint64_t first = number * index_.page_faces_;
    faces.tree->for_each_within(point, limit, [&](std::size_t place) {
      const Triangle& corner = faces.faces[place];
      const double squared = squared_distance(point, box_of(corner));
      if (boxes_.size() > most_near) {
        if (!(squared < boxes_.front().squared)) return;
        std::pop_heap(boxes_.begin(), boxes_.end());
        boxes_.pop_back();
      }
      boxes_.push_back({squared, {first + place, corner}});
      std::push_heap(boxes_.begin(), boxes_.end());
      if (boxes_.size() <= most_near) return;
      limit = boxes_.front().squared > 0 ? boxes_.front().squared : -1;
    });
  });
  last_.squared = std::numeric_limits<double>::infinity();
  for (const NearBox& box : boxes_) take_nearer(point, box.face.face, box.face.corner);
  return boxes_.size() <= most_near || boxes_.front().squared > last_.squared;
}

std::size_t FaceIndex::Reader::most_boxes() {
  return most_near;
}

}  // namespace winnow
