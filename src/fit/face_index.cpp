#include "fit/face_index.hpp"

#include "base/closest_point.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <limits>

namespace winnow {

namespace {

// Boxes of pages overlap: a thread that has fewer of them reads them again and again.
constexpr std::size_t least_slots = 16;
constexpr std::size_t most_slots = 64;
// Faces of a page where all are in memory: trees of many faces overlap less. Where they are not,
// few are read at once.
constexpr std::uint64_t large_page = std::uint64_t{1} << 16;
constexpr std::uint64_t small_page = 512;

std::uint64_t pages_of(std::uint64_t faces, std::uint64_t page) {
  return (faces + page - 1) / page;
}

Box box_of(const Triangle& t) {
  Box box;
  for (const Point& corner : t) box.add(corner);
  return box;
}

}  // namespace

constexpr std::uint64_t FaceIndex::page_bytes(std::uint64_t faces) {
  return faces * (sizeof(Triangle) + sizeof(Box)) + BoxTree::memory(faces);
}

FaceIndex::FaceIndex(Job& job, const StoredMesh& mesh, std::uint64_t memory)
    : job_(job), mesh_(mesh) {
  const auto top = [&](std::uint64_t page) {
    const std::uint64_t pages = pages_of(mesh.face_count, page);
    return pages * sizeof(Box) + BoxTree::memory(pages);
  };
  // One page more a thread while they are made.
  const std::uint64_t making = std::min(large_page, mesh.face_count) * job.threads;
  const std::uint64_t all = top(large_page) + page_bytes(mesh.face_count + making);
  if (all <= memory) reserved_ = job.budget.try_reserve(all);
  page_faces_ = reserved_ ? large_page : small_page;
  boxes_.resize(pages_of(mesh.face_count, page_faces_));
  if (reserved_) {
    resident_.resize(boxes_.size());
  } else {
    const std::uint64_t slot = job.threads * page_bytes(small_page);
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

void FaceIndex::load(std::size_t number, VertexIndex::Reader& vertices, Page& page) const {
  const std::uint64_t first = number * page_faces_;
  const std::uint64_t count = std::min(page_faces_, mesh_.face_count - first);
  std::vector<Box> boxes;
  boxes.reserve(count);
  page.faces.clear();
  page.faces.reserve(count);
  page.area = 0;
  for (const auto& [a, b, c] : mesh_.read_faces(first, count)) {
    const Triangle& t = page.faces.emplace_back(
        Triangle{vertices.position(a), vertices.position(b), vertices.position(c)});
    boxes.push_back(box_of(t));
    page.area += length(doubled_area(t)) / 2;
  }
  page.tree.emplace(boxes);
}

std::size_t FaceIndex::page_near(const Point& point) const {
  double least = std::numeric_limits<double>::max();
  std::size_t near = 0;
  tree_->for_each_within(point, least, [&](std::size_t number) {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off = std::max(
          {boxes_[number].low[axis] - point[axis], point[axis] - boxes_[number].high[axis], 0.0});
      squared += off * off;
    }
    if (squared >= least) return;
    least = squared;
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

const FaceIndex::Nearest& FaceIndex::Reader::nearest(const Point& point) {
  // Points that follow each other are mostly close, so the last face is near.
  last_.place = closest_point(point, last_.corner);
  last_.squared = dot(point - last_.place, point - last_.place);
  index_.tree_->for_each_within(point, last_.squared, [&](std::size_t number) {
    const Page& faces = page(number);
    const std::uint64_t first = number * index_.page_faces_;
    faces.tree->for_each_within(point, last_.squared, [&](std::size_t place) {
      const std::uint64_t face = first + place;
      const Triangle& corner = faces.faces[place];
      const Point here = closest_point(point, corner);
      const double squared = dot(point - here, point - here);
      if (squared > last_.squared || (squared == last_.squared && face >= last_.face)) return;
      last_ = {face, corner, here, squared};
    });
  });
  return last_;
}

}  // namespace winnow
