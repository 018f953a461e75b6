#include "measure/face_intake.hpp"

namespace winnow {

FaceIntake::FaceIntake(Job& job, const Point& origin)
    : parts_(job.threads, [origin] { return std::make_unique<Part>(origin); }), all_(origin) {}

void FaceIntake::add(const GoodFaces& faces) {
  Part& part = parts_.local();
  part.bad.add(faces.bad());
  for (const NumberedFace& face : faces.faces()) part.totals.add(face.corner);
}

void FaceIntake::finish() {
  for (const Part* part : parts_.all()) {
    all_.totals.merge(part->totals);
    all_.bad.add(part->bad);
  }
}

void FaceIntake::report(CompareReport::Mesh& mesh) const {
  mesh.faces = all_.totals.faces();
  mesh.bad_faces = all_.bad;
  mesh.area = all_.totals.area();
  if (all_.totals.closed()) mesh.volume = all_.totals.volume();
}

}  // namespace winnow
