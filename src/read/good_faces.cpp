#include "read/good_faces.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

namespace winnow {

void refuse_bad_face(const std::string& name, const FirstBad& bad) {
  throw Error(ErrorKind::bad_input, "'" + name + "': face " + grouped(bad.face) + " " + bad.what +
                                        "; without `strict` such faces are counted and left out");
}

GoodFaces::GoodFaces(const FaceBatch& faces) {
  for (std::size_t i = 0; i < faces.count; ++i) {
    const Triangle t{faces.corner(0, i), faces.corner(1, i), faces.corner(2, i)};
    if (faces.status[i] == FaceStatus::cropped) {
      ++cropped_;
      continue;
    }
    const char* what = nullptr;
    if (faces.status[i] == FaceStatus::out_of_range) {
      ++bad_.out_of_range;
      what = "names a vertex that does not exist";
    } else if (faces.status[i] == FaceStatus::good &&
               !(finite(t[0]) && finite(t[1]) && finite(t[2]))) {
      ++bad_.non_finite;
      what = "has a corner that is not finite";
    } else if (faces.status[i] != FaceStatus::good || t[0] == t[1] || t[0] == t[2] ||
               t[1] == t[2]) {
      ++bad_.degenerate;
      what = "repeats a corner";
    } else {
      good_[count_++] = {t, faces.first + i};
      continue;
    }
    if (first_bad_.face == UINT64_MAX) first_bad_ = {faces.first + i, what};
  }
}

}  // namespace winnow
