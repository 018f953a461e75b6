#include "run/frame_sheet.hpp"

#include <winnow/error.hpp>

#include "io/byte_sink.hpp"
#include "io/byte_source.hpp"
#include "picture/camera.hpp"
#include "picture/image.hpp"
#include "picture/surface_view.hpp"
#include "read/for_each_batch.hpp"
#include "read/good_faces.hpp"
#include "read/mesh_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>

namespace winnow {

namespace {

constexpr std::size_t most_columns = 8;
constexpr double cell_side = 220;  // pixels; a cell covers about the same area whatever its shape
constexpr double least_side = 100, longest_side = 440;
constexpr std::size_t number_height = 26;
constexpr double number_size = 18;
constexpr Color ground{255, 255, 255};
constexpr Color letters{40, 40, 40};
constexpr double shade = 0.6;  // of all surfaces, by the scale of colours from 0 to 1

using FacesSink = std::function<void(std::span<const NumberedFace>)>;

void for_each_face(Job& job, const std::string& name, const FacesSink& sink) {
  const std::unique_ptr<MeshReader> reader =
      open_reader(job, open_source(job, name), Format::automatic, Access::repeatedly,
                  {job.budget.left() / 4, 2048});
  reader->begin_faces();
  (void)for_each_face_batch(
      job, *reader,
      [&](const FaceBatch& batch) {
        job.progress.check_cancelled();
        sink(GoodFaces(batch).faces());
      },
      [] { return false; });
}

// The first, the last, and some between.
std::vector<std::size_t> shown_frames(std::size_t frames) {
  const std::size_t columns = std::min(frames, most_columns);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < columns; ++i)
    shown.push_back(columns > 1 ? i * (frames - 1) / (columns - 1) : 0);
  return shown;
}

struct Cell {
  explicit Cell(const Box& seen) {
    const Point size = seen.high - seen.low;
    const double root = std::sqrt(std::clamp(size[1] > 0 ? size[0] / size[1] : 4, 0.25, 4.0));
    width = static_cast<std::size_t>(std::clamp(cell_side * root, least_side, longest_side));
    height = static_cast<std::size_t>(std::clamp(cell_side / root, least_side, longest_side));
  }
  std::size_t width, height;
};

}  // namespace

void write_frame_sheet(Job& job, const std::vector<std::string>& originals,
                       const std::vector<std::string>& simplified, const CompareOptions& options) {
  if (!options.picture.ends_with(".png"))
    throw Error(ErrorKind::usage, "`picture` writes .png, not '" + options.picture + "'");
  ByteSink sink(job, options.picture, options.force);
  const std::vector<std::size_t> shown = shown_frames(originals.size());
  job.progress.begin("picture", 3 * shown.size(), "meshes");
  Framing framing(options.view, options.viewer);
  for (const std::size_t frame : shown) {
    for_each_face(job, originals[frame],
                  [&](std::span<const NumberedFace> faces) { framing.add(faces); });
    job.progress.advance(1);
  }
  const Frame seen = framing.frame();
  const Cell cell(seen.box);
  const std::size_t width = cell.width * shown.size();
  const std::size_t height = 2 * cell.height + number_height;
  const Reservation reserved =
      job.budget.reserve(SurfaceView::memory(std::uint64_t{cell.width} * cell.height) +
                             Image::memory(std::uint64_t{width} * height),
                         "the picture");
  Image image(width, height, ground);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    std::size_t top = 0;
    for (const auto* names : {&originals, &simplified}) {
      SurfaceView view(seen, cell.width, cell.height);
      for_each_face(job, (*names)[shown[i]], [&](std::span<const NumberedFace> faces) {
        for (const NumberedFace& face : faces)
          view.draw(face.corner, face.number, {shade, shade, shade});
      });
      view.paint(image, i * cell.width, top, 1);
      top += cell.height;
      job.progress.advance(1);
    }
    image.text((static_cast<double>(i) + 0.5) * static_cast<double>(cell.width),
               static_cast<double>(height) - 8, number_size, std::to_string(shown[i] + 1), letters,
               Image::Align::centre);
  }
  image.write_png(sink);
  sink.finish();
}

}  // namespace winnow
