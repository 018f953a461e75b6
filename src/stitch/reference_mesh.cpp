#include "stitch/reference_mesh.hpp"

#include "base/parallel.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <limits>

namespace winnow {

namespace {

using Extent = ReferenceMesh::Extent;

constexpr std::uint64_t faces_a_block = 256;
constexpr std::uint64_t group = 64;  // blocks, or groups of the level below
constexpr std::uint64_t faces_a_group = group * faces_a_block;
constexpr std::size_t recent_blocks = 64;  // of faces
// No more blocks are looked at for one place, and no more faces given.
constexpr std::size_t most_blocks = 256;
constexpr std::size_t most_near = 8192;
// A face that has to be read takes the time of so many looks.
constexpr std::uint64_t looks_to_read = 8;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Extent nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

Extent extent_of(const Triangle& t) {
  Extent extent;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent.low[axis] = std::min(t[0][axis], std::min(t[1][axis], t[2][axis]));
    extent.high[axis] = std::max(t[0][axis], std::max(t[1][axis], t[2][axis]));
  }
  return extent;
}

void add(Extent& extent, const Extent& more) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent.low[axis] = std::min(extent.low[axis], more.low[axis]);
    extent.high[axis] = std::max(extent.high[axis], more.high[axis]);
  }
}

// each(triangle) for some faces.
template <typename Each>
void for_each_face(const StoredMesh& mesh, VertexIndex::Reader& vertices, std::uint64_t first,
                   std::uint64_t count, const Each& each) {
  for (const auto& [a, b, c] : mesh.read_faces(first, count))
    each(Triangle{vertices.position(a), vertices.position(b), vertices.position(c)});
}

// Blocks that follow each other, with a box around them.
struct Group {
  std::uint64_t first_face = 0;
  Extent whole = nothing;
  std::vector<Extent> blocks;
};

}  // namespace

ReferenceMesh::ReferenceMesh(Job& job, const StoredMesh& mesh, std::uint64_t memory)
    : job_(job),
      mesh_(mesh),
      boxes_(job, memory),
      reserved_(job.budget.reserve((mesh.face_count / faces_a_group + 1) * 3 * sizeof(Extent),
                                   "boxes of faces")) {
  const std::uint64_t faces = mesh.face_count;
  std::vector<Extent> groups;
  std::uint64_t next = 0;
  pipeline<Group>(
      job.threads,
      [&](Group& blocks) {
        blocks.first_face = next;
        next += faces_a_group;
        return blocks.first_face < faces;
      },
      [&](Group& blocks) {
        job_.progress.check_cancelled();
        VertexIndex::Reader vertices(*mesh_.vertices);
        blocks.whole = nothing;
        blocks.blocks.clear();
        const std::uint64_t end = std::min(blocks.first_face + faces_a_group, faces);
        for (std::uint64_t f = blocks.first_face; f < end; f += faces_a_block) {
          Extent& block = blocks.blocks.emplace_back(nothing);
          for_each_face(mesh_, vertices, f, std::min(faces_a_block, end - f),
                        [&](const Triangle& t) { add(block, extent_of(t)); });
          add(blocks.whole, block);
        }
      },
      [&](Group& blocks) {
        groups.push_back(blocks.whole);
        append_records<Extent>(boxes_, blocks.blocks);
      });
  boxes_.finish();
  levels_.push_back(std::move(groups));
  while (levels_.back().size() > 1) {
    const std::vector<Extent>& below = levels_.back();
    std::vector<Extent> level((below.size() + group - 1) / group, nothing);
    for (std::size_t i = 0; i < below.size(); ++i) add(level[i / group], below[i]);
    levels_.push_back(std::move(level));
  }
}

ReferenceMesh::Reader::Reader(const ReferenceMesh& reference, std::uint64_t most_looks)
    : reference_(reference),
      vertices_(*reference.mesh_.vertices),
      boxes_(reference.boxes_, sizeof(Extent)),
      blocks_(recent_blocks),
      looks_left_(most_looks) {}

std::vector<Triangle> ReferenceMesh::Reader::faces_near(const Box& box) {
  reference_.job_.progress.check_cancelled();
  std::vector<Triangle> found;
  found.reserve(faces_a_block);
  std::size_t looked_at = 0;
  const std::size_t top = reference_.levels_.size();
  if (!add_faces(top, 0, {box.low, box.high}, looked_at, found)) found.clear();
  return found;
}

bool ReferenceMesh::Reader::add_faces(std::size_t level, std::uint64_t first, const Extent& place,
                                      std::size_t& looked_at, std::vector<Triangle>& found) {
  const bool blocks = level == 0;
  const std::uint64_t all =
      blocks ? record_count<Extent>(reference_.boxes_) : reference_.levels_[level - 1].size();
  for (std::uint64_t i = first; i < std::min(first + group, all); ++i) {
    if (!boxes_meet(blocks ? boxes_.at<Extent>(i) : reference_.levels_[level - 1][i], place))
      continue;
    if (!blocks) {
      if (!add_faces(level - 1, i * group, place, looked_at, found)) return false;
      continue;
    }
    if (++looked_at > most_blocks || looks_left_ == 0) return false;
    for (const Triangle& t : block(i)) {
      if (!boxes_meet(extent_of(t), place)) continue;
      if (found.size() == most_near) return false;
      found.push_back(t);
    }
  }
  return true;
}

const std::vector<Triangle>& ReferenceMesh::Reader::block(std::uint64_t number) {
  Block& block = blocks_[number % recent_blocks];
  const bool known = block.number == number;
  looks_left_ -= std::min(looks_left_, (known ? 1 : looks_to_read) * faces_a_block);
  if (!known) {
    block.number = UINT64_MAX;  // should reading fail
    block.faces.clear();
    block.faces.reserve(faces_a_block);
    const std::uint64_t first = number * faces_a_block;
    for_each_face(reference_.mesh_, vertices_, first,
                  std::min(faces_a_block, reference_.mesh_.face_count - first),
                  [&](const Triangle& t) { block.faces.push_back(t); });
    block.number = number;
  }
  return block.faces;
}

std::uint64_t ReferenceMesh::Reader::most_faces() {
  return most_near;
}

std::uint64_t ReferenceMesh::Reader::memory() {
  return recent_blocks * faces_a_block * sizeof(Triangle) +
         2 * RecentBlocks::most_blocks * RecentBlocks::block_bytes;
}

}  // namespace winnow
