#include "cluster/face_list.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace winnow {

FaceList::FaceList(Job& job, std::uint64_t memory, SortedRuns<CellFace>& runs)
    : job_(job), budget_(memory), pages_(budget_, memory), runs_(runs) {}

void FaceList::add(CellKey a, CellKey b, CellKey c) {
  if ((count_ + 1) * sizeof(CellFace) > pages_.usable() && !pages_.grow_to((count_ + 1) * sizeof(CellFace)))
    make_room();
  // Each exchange mirrors the face.
  bool along = true;
  const auto order = [&along](CellKey& low, CellKey& high) {
    if (high < low) {
      std::swap(low, high);
      along = !along;
    }
  };
  order(a, b);
  order(b, c);
  order(a, b);
  reinterpret_cast<CellFace*>(pages_.data())[count_++] = {{a, b, c}, along ? 1U : 0U, along ? 0U : 1U};
}

void FaceList::sort_and_combine() {
  const std::span<CellFace> all = faces();
  std::sort(all.begin(), all.end(), job_.progress.cancellable(Before<CellFace>()));
  std::size_t kept = 0;
  for (const CellFace& face : all) {
    if (kept > 0 && all[kept - 1].cell == face.cell && CellFace::combine(all[kept - 1], face)) continue;
    all[kept++] = face;
  }
  count_ = kept;
}

void FaceList::make_room() {
  sort_and_combine();
  // Where most faces were repeats there is room again without writing.
  if (count_ * sizeof(CellFace) <= pages_.usable() / 4) return;
  MemoryCursor<CellFace> all(faces());
  runs_.add(all);
  count_ = 0;
}

void FaceList::finish(std::vector<std::unique_ptr<RecordCursor<CellFace>>>& sources) {
  if (count_ > 0) sources.push_back(std::make_unique<MemoryCursor<CellFace>>(faces()));
}

}  // namespace winnow
