// What the picture of a comparison shows, pixel by pixel.
#include <winnow/compare.hpp>

#include "support/files.hpp"
#include "support/job.hpp"
#include "support/stl_file.hpp"
#include "support/surfaces.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#include <cairo.h>
#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

constexpr std::size_t picture_label_rows = 44, picture_scale_rows = 112;

struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint32_t> pixels{};  // 0xRRGGBB

  // Pixels of text have no colour, those of surfaces and of the scale have one.
  template <typename Test>
  [[nodiscard]] Picture cut(std::size_t left, std::size_t top, std::size_t right,
                            std::size_t bottom, Test&& test) const {
    Picture part{right - left, bottom - top};
    for (std::size_t y = top; y < bottom; ++y) {
      for (std::size_t x = left; x < right; ++x) {
        const std::uint32_t pixel = pixels[y * width + x];
        const auto [least, most] = std::minmax({pixel >> 16, pixel >> 8 & 255, pixel & 255});
        part.pixels.push_back(test(pixel, most - least > 20) ? 1 : 0);
      }
    }
    return part;
  }
  [[nodiscard]] Picture text(std::size_t left, std::size_t top, std::size_t right,
                             std::size_t bottom) const {
    return cut(left, top, right, bottom,
               [](std::uint32_t pixel, bool colored) { return !colored && pixel != 0xFFFFFF; });
  }
  [[nodiscard]] Picture surfaces() const {
    return cut(0, 0, width, height - picture_scale_rows,
               [](std::uint32_t, bool colored) { return colored; });
  }
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::count(pixels.begin(), pixels.end(), 1U));
  }
};

Picture picture_at(const std::string& path) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> image(
      cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy);
  REQUIRE(cairo_surface_status(image.get()) == CAIRO_STATUS_SUCCESS);
  Picture picture{static_cast<std::size_t>(cairo_image_surface_get_width(image.get())),
                  static_cast<std::size_t>(cairo_image_surface_get_height(image.get()))};
  const unsigned char* bytes = cairo_image_surface_get_data(image.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = 0; x < picture.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, bytes + y * stride + x * sizeof pixel, sizeof pixel);
      picture.pixels.push_back(pixel & 0xFFFFFF);
    }
  }
  return picture;
}

// The picture of two meshes, and the bytes of its file.
class Pictured {
 public:
  Pictured(const std::vector<Triangle>& original, const std::vector<Triangle>& simplified) {
    write_file(directory_.file("original.stl"), binary_stl(original));
    write_file(directory_.file("simplified.stl"), binary_stl(simplified));
    options.samples = 1000;
    options.picture = directory_.file("picture.png");
    options.force = true;
  }

  Picture draw(View view = View::iso, const Point& viewer = {}) {
    options.view = view;
    options.viewer = viewer;
    Context context;
    context.threads = 2;
    context.scratch = directory_.path();
    compare(context, directory_.file("original.stl"), directory_.file("simplified.stl"), options);
    return picture_at(options.picture);
  }

  CompareOptions options;

 private:
  Directory directory_;
};

// The surface of a box from the origin on.
std::vector<Triangle> box_faces(const Point& size) {
  std::vector<Triangle> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 1.0}) {
      const auto corner = [&](double u, double v) {
        Point p{};
        p[axis] = side * size[axis];
        p[(axis + 1) % 3] = u * size[(axis + 1) % 3];
        p[(axis + 2) % 3] = v * size[(axis + 2) % 3];
        return p;
      };
      faces.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
      faces.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
    }
  }
  return faces;
}

std::vector<Triangle> enlarged(std::vector<Triangle> faces, double by) {
  for (Triangle& face : faces) {
    for (Point& corner : face) corner = by * corner;
  }
  return faces;
}

}  // namespace

TEST_CASE("the picture names both meshes above them") {
  const Picture picture = Pictured(box_faces({1, 1, 1}), box_faces({1, 1, 1.01})).draw();
  const std::size_t half = picture.width / 2;
  const Picture left = picture.text(0, 0, half, picture_label_rows);
  const Picture right = picture.text(half, 0, 2 * half, picture_label_rows);
  CHECK(left.count() > 100);
  CHECK(10 * right.count() > 11 * left.count());  // the longer word
  // In the middle of each half and nowhere else.
  CHECK(picture.text(half / 3, 0, 2 * half / 3, picture_label_rows).count() == left.count());
  CHECK(picture.text(half + half / 3, 0, half + 2 * half / 3, picture_label_rows).count() ==
        right.count());
}

TEST_CASE("numbers beside the scale are of this comparison, in both units") {
  const auto scale = [](double size, double off) {
    const Picture picture =
        Pictured(enlarged(box_faces({1, 1, 1}), size), enlarged(box_faces({1, 1, 1 + off}), size))
            .draw();
    const std::size_t top = picture.height - 64;
    return std::pair(picture.text(0, top + 4, picture.width, top + 28).pixels,
                     picture.text(0, top + 34, picture.width, picture.height).pixels);
  };
  const auto [lengths, percents] = scale(1, 0.01);
  CHECK(std::count(lengths.begin(), lengths.end(), 1U) > 300);
  CHECK(std::count(percents.begin(), percents.end(), 1U) > 300);
  const auto [larger_lengths, larger_percents] = scale(2, 0.01);
  CHECK(larger_lengths != lengths);
  CHECK(larger_percents == percents);
  const auto [farther_lengths, farther_percents] = scale(1, 0.02);
  CHECK(farther_lengths != lengths);
  CHECK(farther_percents != percents);
  // Without any distance there is one number, and no other.
  const auto [none, no_percents] = scale(1, 0);
  CHECK(std::count(none.begin(), none.end(), 1U) < std::count(lengths.begin(), lengths.end(), 1U));
}

TEST_CASE("the picture fits meshes of any shape to its frame", "[long]") {
  for (const Point& size : {Point{1, 1, 1}, Point{1, 4, 1}, Point{6, 1, 1}, Point{1, 1, 4},
                            Point{4, 3, 0.1}, Point{1e6, 1e6, 1e6}, Point{1e-9, 1e-9, 1e-9}}) {
    Pictured pictured(box_faces(size), box_faces(size));
    for (const View view : {View::iso, View::front, View::top}) {
      const Picture surfaces = pictured.draw(view).surfaces();
      std::size_t left = surfaces.width, right = 0, top = surfaces.height, bottom = 0;
      for (std::size_t y = 0; y < surfaces.height; ++y) {
        for (std::size_t x = 0; x < surfaces.width; ++x) {
          if (surfaces.pixels[y * surfaces.width + x] == 0) continue;
          left = std::min(left, x);
          right = std::max(right, x + 1);
          top = std::min(top, y);
          bottom = std::max(bottom, y + 1);
        }
      }
      INFO(size[0] << " " << size[1] << " " << size[2] << " view " << static_cast<int>(view));
      REQUIRE(left < right);
      CHECK(left > 0);
      CHECK(right < surfaces.width);
      const auto wide = static_cast<double>(right - left) / static_cast<double>(surfaces.width);
      const auto high = static_cast<double>(bottom - top) /
                        static_cast<double>(surfaces.height - picture_label_rows);
      const bool thin = size[2] < 1 && view == View::front;
      CHECK(wide > 0.9);
      CHECK((thin || high > 0.85));
    }
  }
}

TEST_CASE("a mesh that lies elsewhere is in the picture too") {
  std::vector<Triangle> moved = box_faces({1, 1, 1});
  for (Triangle& face : moved) {
    for (Point& corner : face) corner = corner + Point{3, 0, 0};
  }
  const Picture picture = Pictured(box_faces({1, 1, 1}), moved).draw(View::front).surfaces();
  CHECK(picture
            .cut(0, 0, picture.width, picture.height / 2,
                 [](std::uint32_t pixel, bool) { return pixel != 0; })
            .count() > 1000);
  CHECK(picture
            .cut(0, picture.height / 2, picture.width, picture.height,
                 [](std::uint32_t pixel, bool) { return pixel != 0; })
            .count() > 1000);
}

TEST_CASE("the picture is seen from where it is asked for", "[long]") {
  std::vector<Triangle> faces = box_faces({3, 2, 2.5});
  faces.resize(faces.size() - 1);  // so that every side looks different
  Pictured pictured(faces, box_faces({3, 2, 2.6}));
  const auto bytes = [&](View view, const Point& viewer = {}) {
    pictured.draw(view, viewer);
    return bytes_of_file(pictured.options.picture);
  };
  const std::string iso = bytes(View::iso);
  CHECK(CompareOptions{}.view == View::iso);
  CHECK(bytes(View::from, {2, 2, 2}) == iso);
  CHECK(bytes(View::front) == bytes(View::from, {0, 0, 1e-3}));
  CHECK(bytes(View::top) == bytes(View::from, {0, 1e9, 0}));
  CHECK(bytes(View::front) != iso);
  CHECK(bytes(View::top) != iso);
  CHECK(bytes(View::top) != bytes(View::front));
  CHECK(bytes(View::from, {0, -1, 0}) != bytes(View::top));
  for (const Point& nowhere : {Point{0, 0, 0}, Point{std::nan(""), 0, 0}, Point{0, HUGE_VAL, 0}})
    CHECK(error_of([&] { pictured.draw(View::from, nowhere); }).kind() == ErrorKind::usage);
}

}  // namespace winnow::test
