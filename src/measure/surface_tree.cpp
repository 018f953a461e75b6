#include "measure/surface_tree.hpp"

#include <winnow/error.hpp>

#include "base/box.hpp"
#include "base/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <embree3/rtcore.h>

namespace winnow {

namespace {

// Boxes, points and radii are rounded to float, and Embree computes with floats: all of it errs by
// a few 2^-24 of the coordinates. Boxes and radii grow by this part of them, so that no face is
// missed.
constexpr double slack = 1.0 / (1 << 20);

// Embree takes no box beyond 2^60; coordinates are scaled to about 1. Points farther away than this
// are held against every face.
constexpr double far_away = 1e15;

}  // namespace

struct SurfaceTree::State {
  std::span<const NumberedFace> faces;
  Reservation reservation;
  Job* job = nullptr;
  Box box;
  Point centre{};
  double scale = 1;  // a power of two
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void find_centre() {
    for (const NumberedFace& face : faces) {
      for (const Point& p : face.corner) box.add(p);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = middle_of(axis);
    const double side = box.longest_side();
    scale = side > 0 ? std::ldexp(1.0, -std::ilogb(side)) : 1;
  }

  // Where most faces are: floats are finest there, and one that lies far away must not coarsen the
  // others.
  [[nodiscard]] double middle_of(std::size_t axis) const {
    std::vector<double> some;
    const std::size_t step = faces.size() / 1024 + 1;
    for (std::size_t i = 0; i < faces.size(); i += step) some.push_back(faces[i].corner[0][axis]);
    const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    return *middle;
  }

  [[nodiscard]] Point scaled(const Point& p) const { return scale * (p - centre); }

  // To the box around all faces.
  [[nodiscard]] double squared_to_box(const Point& p) const {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double away = std::max({box.low[axis] - p[axis], p[axis] - box.high[axis], 0.0});
      squared += away * away;
    }
    return squared;
  }

  void check() const {
    job->progress.check_cancelled();
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
  double scale;
  double margin;  // scaled
  bool found = false;

  // The radius within which a face can still matter; equally near ones do, as their numbers decide.
  [[nodiscard]] float radius() const {
    if (best->squared < enough) return 0;
    const double distance = scale * std::sqrt(best->squared) * (1 + 1e-6) + margin;
    return distance < far_away ? static_cast<float>(distance)
                               : std::numeric_limits<float>::infinity();
  }

  bool look_at(const NumberedFace& face) {
    const NearestFace near = distance_to(face, point);
    if (!best->farther_than(near.squared, near.number)) return false;
    *best = near;
    found = true;
    return true;
  }
};

bool visit(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  if (search.best->squared < search.enough) return false;
  if (!search.look_at(search.faces[arguments->primID])) return false;
  arguments->query->radius = search.radius();
  return true;
}

}  // namespace

SurfaceTree::SurfaceTree(Job& job, std::span<const NumberedFace> faces)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.job = &job;
  state.faces = faces;
  if (faces.empty()) return;
  if (faces.size() > most_faces)
    throw Error(ErrorKind::failed, "too many faces for one search tree");
  state.reservation = job.budget.reserve(faces.size() * bytes_a_face, "a search tree");
  state.find_centre();
  // It works in the arena that it is called from. If it were told a number of threads, it would set
  // that for the whole process.
  state.device = rtcNewDevice(nullptr);
  if (state.device == nullptr)
    throw Error(ErrorKind::failed, "Embree does not run on this machine");
  state.scene = rtcNewScene(state.device);
  RTCGeometry geometry = rtcNewGeometry(state.device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(faces.size()));
  rtcSetGeometryUserData(geometry, &state);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* arguments) {
        const auto& s = *static_cast<const State*>(arguments->geometryUserPtr);
        const Triangle& t = s.faces[arguments->primID].corner;
        const Triangle scaled{s.scaled(t[0]), s.scaled(t[1]), s.scaled(t[2])};
        std::array<float, 3> low{};
        std::array<float, 3> high{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double lowest = std::min({scaled[0][axis], scaled[1][axis], scaled[2][axis]});
          const double highest = std::max({scaled[0][axis], scaled[1][axis], scaled[2][axis]});
          low[axis] = static_cast<float>(lowest - slack * std::abs(lowest));
          high[axis] = static_cast<float>(highest + slack * std::abs(highest));
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
  rtcSetSceneProgressMonitorFunction(
      state.scene,
      [](void* progress, double /*done*/) {
        return !static_cast<ProgressMeter*>(progress)->cancelled();
      },
      &job.progress);
  rtcCommitScene(state.scene);
  state.check();
}

SurfaceTree::~SurfaceTree() = default;

bool SurfaceTree::search(const Point& point, NearestFace& best, double enough_squared) const {
  const State& state = *state_;
  if (state.faces.empty() || best.squared < enough_squared) return false;
  if (state.squared_to_box(point) * (1 - 1e-9) > best.squared) return false;
  const Point at = state.scaled(point);
  const double size = std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  Search search{state.faces, point, &best, enough_squared, state.scale, slack * size};
  if (!(size < far_away)) {
    for (const NumberedFace& face : state.faces) search.look_at(face);
    return search.found;
  }
  alignas(16) RTCPointQuery query{};
  query.x = static_cast<float>(at[0]);
  query.y = static_cast<float>(at[1]);
  query.z = static_cast<float>(at[2]);
  query.radius = search.radius();
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(state.scene, &query, &context, nullptr, &search);
  return search.found;
}

bool NeighbourSearch::search(const Point& point, NearestFace& best, double enough_squared) {
  bool found = false;
  if (last_ != nullptr) {
    const NearestFace guess = distance_to(*last_, point);
    found = best.farther_than(guess.squared, guess.number);
    if (found) best = guess;
  }
  found = tree_.search(point, best, enough_squared) || found;
  if (found) last_ = best.face;
  return found;
}

}  // namespace winnow
