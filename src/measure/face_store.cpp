#include "measure/face_store.hpp"

#include <algorithm>

namespace winnow {

FaceStore::FaceStore(Budget& budget, std::uint64_t faces)
    : pages_(budget, faces * sizeof(NumberedFace)) {}

bool FaceStore::add(std::span<const NumberedFace> faces) {
  const std::scoped_lock lock(mutex_);
  const std::size_t count = count_;
  if (!pages_.grow_to((count + faces.size()) * sizeof(NumberedFace))) return false;
  std::copy(faces.begin(), faces.end(), reinterpret_cast<NumberedFace*>(pages_.data()) + count);
  count_ = count + faces.size();
  return true;
}

void FaceStore::sort(Job& job) {
  const std::span<NumberedFace> all = span();
  std::sort(all.begin(), all.end(),
            job.progress.cancellable(
                [](const NumberedFace& a, const NumberedFace& b) { return a.number < b.number; }));
}

std::span<NumberedFace> FaceStore::span() const {
  return {reinterpret_cast<NumberedFace*>(pages_.data()), count_};
}

}  // namespace winnow
