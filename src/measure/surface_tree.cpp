#include "measure/surface_tree.hpp"

#include <winnow/error.hpp>

#include "measure/closest_point.hpp"

#include <algorithm>
#include <atomic>
#include <string>

#include <embree3/rtcore.h>

namespace winnow {

namespace {

// Boxes and radii are rounded to float, and Embree computes with floats: all of it errs by a few 2^-24 of the
// surface's size. Boxes grow by this part of it, so that no face is missed.
constexpr double slack = 1.0 / (1 << 20);

}  // namespace

struct SurfaceTree::State {
  std::span<const NumberedFace> faces;
  Reservation reservation;
  Point low{}, high{}, centre{};
  double margin = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void find_centre() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const NumberedFace& face : faces) {
      for (const Point& p : face.corner) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], p[axis]);
          high[axis] = std::max(high[axis], p[axis]);
        }
      }
    }
    double side = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centre[axis] = low[axis] + (high[axis] - low[axis]) / 2;
      side = std::max(side, high[axis] - low[axis]);
    }
    margin = side * slack;
  }

  // To the box around all faces.
  [[nodiscard]] double squared_to_box(const Point& p) const {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double away = std::max({low[axis] - p[axis], p[axis] - high[axis], 0.0});
      squared += away * away;
    }
    return squared;
  }

  void check() const {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
      throw Error(ErrorKind::resources, "the search tree over " + std::to_string(faces.size()) +
                                            " faces could not be built; is there enough memory?");
    }
  }
};

NearestFace distance_to(const NumberedFace& face, const Point& point) {
  const Point away = point - closest_point(point, face.corner);
  return {dot(away, away), face.number, &face};
}

namespace {

struct Search {
  std::span<const NumberedFace> faces;
  Point point;
  NearestFace* best;
  double enough;
  double margin;
  bool found = false;

  // The radius within which a face can still matter; equally near ones do, as their numbers decide.
  [[nodiscard]] float radius() const {
    if (best->squared < enough) return 0;
    const double distance = std::sqrt(best->squared) * (1 + 1e-6) + margin;
    return distance < 1e37 ? static_cast<float>(distance) : std::numeric_limits<float>::infinity();
  }
};

bool visit(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  if (search.best->squared < search.enough) return false;
  const NumberedFace& face = search.faces[arguments->primID];
  const NearestFace near = distance_to(face, search.point);
  if (!search.best->farther_than(near.squared, near.number)) return false;
  *search.best = near;
  search.found = true;
  arguments->query->radius = search.radius();
  return true;
}

}  // namespace

SurfaceTree::SurfaceTree(Job& job, std::span<const NumberedFace> faces) : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.faces = faces;
  if (faces.empty()) return;
  state.reservation = job.budget.reserve(faces.size() * bytes_a_face, "a search tree");
  state.find_centre();
  state.device = rtcNewDevice(("threads=" + std::to_string(job.threads)).c_str());
  if (state.device == nullptr) throw Error(ErrorKind::failed, "Embree does not run on this machine");
  state.scene = rtcNewScene(state.device);
  // Embree numbers faces with 32 bits; larger surfaces come in many trees.
  RTCGeometry geometry = rtcNewGeometry(state.device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(faces.size()));
  rtcSetGeometryUserData(geometry, &state);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* arguments) {
        const auto& s = *static_cast<const State*>(arguments->geometryUserPtr);
        const Triangle& t = s.faces[arguments->primID].corner;
        std::array<float, 3> low{};
        std::array<float, 3> high{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] =
              static_cast<float>(std::min({t[0][axis], t[1][axis], t[2][axis]}) - s.centre[axis] - s.margin);
          high[axis] =
              static_cast<float>(std::max({t[0][axis], t[1][axis], t[2][axis]}) - s.centre[axis] + s.margin);
        }
        RTCBounds& bounds = *arguments->bounds_o;
        bounds.lower_x = low[0];
        bounds.lower_y = low[1];
        bounds.lower_z = low[2];
        bounds.upper_x = high[0];
        bounds.upper_y = high[1];
        bounds.upper_z = high[2];
      },
      nullptr);
  rtcSetGeometryPointQueryFunction(geometry, visit);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(state.scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(state.scene);
  state.check();
}

SurfaceTree::~SurfaceTree() = default;

bool SurfaceTree::search(const Point& point, NearestFace& best, double enough_squared) const {
  const State& state = *state_;
  if (state.faces.empty() || state.squared_to_box(point) * (1 - 1e-9) > best.squared) return false;
  Search search{state.faces, point, &best, enough_squared, state.margin};
  alignas(16) RTCPointQuery query{};
  query.x = static_cast<float>(point[0] - state.centre[0]);
  query.y = static_cast<float>(point[1] - state.centre[1]);
  query.z = static_cast<float>(point[2] - state.centre[2]);
  query.radius = search.radius();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(state.scene, &query, &context, nullptr, &search);
  return search.found;
}

}  // namespace winnow
