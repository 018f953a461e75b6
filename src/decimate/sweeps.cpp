#include "decimate/sweeps.hpp"

#include "base/hash.hpp"
#include "base/instruction_set.hpp"
#include "base/rounding.hpp"
#include "decimate/quadric_placement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace winnow {

namespace {

constexpr std::uint32_t turns_between = 1024;
// Of the proposed edges those that a sweep looks at: with more the order of costs is lost, with
// fewer there are more sweeps (bench/RESULTS.md).
constexpr double share_of_coarse_sweep = 0.8;
constexpr double share_of_sweep = 0.6;
constexpr double share_of_fine_sweep = 0.4;
// Beside what so many of these cost at most, what the others may: else what has a shape goes while
// flat edges are left, as at a vertex from which these lead to lower numbers alone.
constexpr double usual_share = 0.3;
constexpr double beside_usual = 256;
// Sweeps are coarse down to so many times the faces at which they begin to be fine, and one in so
// many of all: edges keep the costs that they had when the sweep began.
constexpr std::uint64_t coarse_beside_fine = 2;
constexpr std::uint64_t coarse_of_all = 5;
// So many classes of costs, 64 octaves, are alike in a coarse sweep: it goes through the mesh in
// its order, where what is beside an edge is in the caches already. Flat edges still go first.
constexpr std::uint32_t classes_alike_when_coarse = 1024;
// Beside the costliest that a sweep looks at, how costly an edge may be that turns out to be
// costlier.
constexpr double closer_bound = 0.25;
// A sweep is the last that collapses no more than one in so many of these.
constexpr std::size_t worth_a_sweep = 8;

}  // namespace

Sweeps::Sweeps(TileMesh& mesh, bool single, const CollapseRules& rules)
    : mesh_(mesh),
      single_(single),
      rules_(rules),
      evaluate_edges_(best_kernel(WINNOW_KERNELS(edge_kernel))),
      take_planes_(best_kernel(WINNOW_KERNELS(plane_kernel))),
      legality_(mesh, rules.least_cosine),
      star_(rules.rounding),
      witnesses_(mesh, rules.rounding.relative) {}

bool Sweeps::run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done,
                 const std::function<void()>& turn) {
  const std::uint64_t least = std::max(limits.faces, limits.sweeps_to);
  std::uint64_t left = mesh_.live_faces();
  if (left <= least) return left <= limits.faces;
  begin();
  const std::uint64_t coarse_to =
      std::max(coarse_beside_fine * limits.fine_from, left / coarse_of_all);
  std::uint32_t turns = 0;
  const double costliest = std::min(limits.cost, limits.sweeps_cost);
  const auto is_done = [&] { return left <= least || highest_ > costliest; };
  for (bool stalled = false; !is_done() && !stalled;) {
    sum_planes();
    evaluate_edges();
    coarse_ = left > coarse_to;
    star_.want_planes(!coarse_);
    const double part = coarse_                   ? share_of_coarse_sweep
                        : left > limits.fine_from ? share_of_sweep
                                                  : share_of_fine_sweep;
    const auto proposed = static_cast<double>(proposals_.count(vertices_));
    const auto share = static_cast<std::uint64_t>(part * proposed);
    const auto [cheapest, bound] =
        proposals_.cheapest(vertices_, std::min(share, (left - limits.sweeps_to) / 2 + 1),
                            1 + static_cast<std::uint64_t>(usual_share * proposed), beside_usual,
                            coarse_ ? classes_alike_when_coarse : 1);
    std::size_t made = 0;
    for (const VertexNumber low : cheapest) {
      if (turns++ % turns_between == 0 && turn) turn();
      if (is_done()) break;
      if (!take(low, bound)) continue;
      const unsigned faces = collapse(edge_, cost_);
      left -= faces;
      done({edge_, highest_, faces, std::sqrt(largest_square_)});
      ++made;
    }
    rewrite_faces();
    stalled = made <= cheapest.size() / worth_a_sweep;
  }
  mesh_.replace_faces(faces_);
  return left <= limits.faces || highest_ > limits.cost;
}

void Sweeps::begin() {
  const VertexNumber count = mesh_.vertex_count();
  faces_.clear();
  faces_.reserve(mesh_.live_faces());
  for (FaceNumber f = 0; f < mesh_.face_count(); ++f) {
    if (!mesh_.removed(f)) faces_.push_back({mesh_.face(f), f});
  }
  corners_ = CornerLists(count);
  corners_.make(std::span<const SurvivingFace>(faces_));
  at_boundary_.resize(count);
  vertices_.clear();
  for (VertexNumber v = 0; v < count; ++v) {
    mesh_.update_hub(v, corners_.degree(v));
    std::uint64_t odd = 0;
    for (const auto [w, x] : corners_.of(v)) odd ^= mixed_hash(w) ^ mixed_hash(x);
    at_boundary_[v] = odd != 0;
    if (!mesh_.locked(v) && corners_.degree(v) != 0) vertices_.push_back(v);
  }
  proposals_ = Proposals(count);
  planes_.resize(count);
  into_.resize(count);
  std::iota(into_.begin(), into_.end(), 0U);
  state_.assign(count, untouched);
}

void Sweeps::sum_planes() {
  std::fill(planes_.begin(), planes_.end(), VertexPlanes{});
  const StarRules rules{rules_.least_cosine, rules_.rounding.relative, rules_.rounding.absolute};
  for (std::size_t first = 0; first < faces_.size(); first += StarBatch::capacity) {
    const std::size_t count = std::min(StarBatch::capacity, faces_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const auto [a, b, c] = faces_[first + i].vertices;
      set_corners(face_batch_, i, mesh_.position(a), mesh_.position(b), mesh_.position(c));
    }
    take_planes_(face_batch_, count, rules);
    for (std::size_t i = 0; i < count; ++i) {
      const VertexPlanes planes = planes_of(face_batch_.planes, i);
      for (const VertexNumber v : faces_[first + i].vertices) add(planes_[v], planes);
    }
  }
  for (const VertexNumber v : vertices_) {
    if (!at_boundary_[v]) continue;
    find_single_neighbours(v);
    for (const VertexNumber w : met_)
      add_line(planes_[v], mesh_.position(w) - mesh_.position(v), boundary_line_weight);
  }
}

// Leaves the vertices that share one face with `v` in met_.
void Sweeps::find_single_neighbours(VertexNumber v) {
  met_.clear();
  for (const auto [w, x] : corners_.of(v)) met_.insert(met_.end(), {w, x});
  keep_single(met_);
}

void Sweeps::evaluate_edges() {
  for (const VertexNumber low : vertices_) {
    proposals_.clear(low);
    if (mesh_.hub(low)) continue;
    // An edge is told by the face in which it leads from its lower end to the higher, or to a
    // hub.
    for (const auto [high, other] : corners_.of(low)) add_edge(low, high);
    if (!at_boundary_[low]) continue;
    // Or by its only one.
    find_single_neighbours(low);
    for (const VertexNumber high : met_) {
      const auto leads = [high](const OtherCorners& corners) { return corners.w == high; };
      const auto corners = corners_.of(low);
      if (std::none_of(corners.begin(), corners.end(), leads)) add_edge(low, high);
    }
  }
  evaluate_batch();
}

// Which edges are told is a coin toss, so there is no branch on it.
void Sweeps::add_edge(VertexNumber low, VertexNumber high) {
  lows_[in_batch_] = low;
  highs_[in_batch_] = high;
  in_batch_ += static_cast<std::size_t>(((low < high) | mesh_.hub(high)) & !mesh_.closed(high));
  if (in_batch_ == EdgeBatch::capacity) evaluate_batch();
}

void Sweeps::evaluate_batch() {
  for (std::size_t i = 0; i < in_batch_; ++i) {
    set_low(batch_, i, mesh_.position(lows_[i]), planes_[lows_[i]]);
    set_high(batch_, i, mesh_.position(highs_[i]), planes_[highs_[i]], mesh_.hub(highs_[i]));
  }
  evaluate_edges_(batch_, in_batch_, single_);
  for (std::size_t i = 0; i < in_batch_; ++i) {
    proposals_.add(lows_[i], {batch_.cost[i], position_of(batch_, i), highs_[i],
                              batch_.flat_low[i] != 0, batch_.flat_high[i] != 0});
  }
  in_batch_ = 0;
}

// As EdgeStar::find(), after the collapses of this sweep.
void Sweeps::gather_star(VertexNumber low, VertexNumber high) {
  star_.begin(low, high);
  for (const auto [before_w, before_x] : corners_.of(low)) {
    const VertexNumber w = into_[before_w];
    const VertexNumber x = into_[before_x];
    if (w != x) star_.add_of_kept({no_number, w, x, w != high && x != high});
  }
  for (const auto [before_w, before_x] : corners_.of(high)) {
    const VertexNumber w = into_[before_w];
    const VertexNumber x = into_[before_x];
    if ((w != x) & (w != low) & (x != low)) star_.add_of_removed({no_number, w, x, true});
  }
}

void Sweeps::gather_star_at_hub(VertexNumber low, VertexNumber hub) {
  star_.begin(hub, low);
  const auto at_edge = [hub](VertexNumber w, VertexNumber x) { return (w == hub) | (x == hub); };
  for (const auto [before_w, before_x] : corners_.of(low)) {
    const VertexNumber w = into_[before_w];
    const VertexNumber x = into_[before_x];
    if (w == x || !at_edge(w, x)) continue;
    star_.add_of_kept({no_number, w == hub ? x : low, w == hub ? low : w, false});
  }
  for (const auto [before_w, before_x] : corners_.of(low)) {
    const VertexNumber w = into_[before_w];
    const VertexNumber x = into_[before_x];
    if (w != x && !at_edge(w, x)) star_.add_of_removed({no_number, w, x, true});
  }
}

// By the rules of Legality::keeps_surface(). What would leave nothing of a piece is not taken.
bool Sweeps::keeps_surface() {
  const TileMesh::Meeting meeting =
      mesh_.meeting(star_.of_kept(), star_.removed(), star_.of_removed());
  if (meeting.faces == 0 || meeting.common != meeting.faces || meeting.falls_together) return false;
  if (star_.faces().size() == meeting.faces) return false;
  if (meeting.faces != 2 || !at_boundary_[star_.removed()]) return true;
  return !is_open(star_.removed()) || !is_open(star_.kept());
}

// The same where a hub is kept. What is beside it is asked of the other vertices, so none of these
// may have changed; and of a face whose corners are all beside it nothing is known.
bool Sweeps::keeps_surface_at_hub() {
  const VertexNumber hub = star_.kept();
  std::vector<VertexNumber> across;
  for (const StarFace& face : star_.of_kept())
    across.push_back(face.w == star_.removed() ? face.x : face.w);
  const auto is_across = [&](VertexNumber v) {
    return std::find(across.begin(), across.end(), v) != across.end();
  };
  if (across.empty() || (across.size() == 2 && across[0] == across[1])) return false;
  if (across.size() > 2 || star_.of_removed().empty()) return false;
  for (const StarFace& face : star_.of_removed()) {
    if (is_across(face.w) && is_across(face.x)) return false;
    for (const VertexNumber w : {face.w, face.x}) {
      if (is_across(w)) continue;
      if (state_[w] != untouched || mesh_.locked(w) || mesh_.hub(w)) return false;
      const auto corners = corners_.of(w);
      const auto has_hub = [&](const OtherCorners& c) {
        return into_[c.w] == hub || into_[c.x] == hub;
      };
      if (std::any_of(corners.begin(), corners.end(), has_hub)) return false;
    }
  }
  return across.size() != 2 || !at_boundary_[star_.removed()] || !is_open(star_.removed());
}

// Whether an end of the edge shares one face with some vertex.
bool Sweeps::is_open(VertexNumber end) {
  met_.clear();
  const bool kept = end == star_.kept();
  for (const StarFace& face : star_.of_kept()) {
    if (kept) {
      met_.insert(met_.end(), {face.w, face.x});
    } else if (!face.stays) {
      met_.insert(met_.end(), {star_.kept(), face.w == end ? face.x : face.w});
    }
  }
  if (!kept) {
    for (const StarFace& face : star_.of_removed()) met_.insert(met_.end(), {face.w, face.x});
  }
  keep_single(met_);
  return !met_.empty();
}

// Whether a vertex of the star is not where it was when costs were asked for.
bool Sweeps::has_moved_beside() const {
  return std::any_of(star_.faces().begin(), star_.faces().end(), [this](const StarFace& face) {
    return state_[face.w] == moved || state_[face.x] == moved;
  });
}

// Whether the edge that `low` proposes may be collapsed: then it is edge_.
bool Sweeps::take(VertexNumber low, double bound) {
  EvaluatedEdge proposed = proposals_.of(low);
  const VertexNumber high = proposed.high;
  if ((state_[low] != untouched) | (state_[high] != untouched)) return false;
  const bool hub = mesh_.hub(high);
  if (hub) {
    gather_star_at_hub(low, high);
    if (!keeps_surface_at_hub()) return false;
  } else {
    if (corners_.degree(low) + corners_.degree(high) > most_faces_beside_hubs) return false;
    gather_star(low, high);
    if (!keeps_surface()) return false;
  }
  if (!coarse_ && has_moved_beside()) {
    proposals_.clear(low);
    add_edge(low, high);
    evaluate_batch();
    proposed = proposals_.of(low);
    if (!(proposed.cost < bound)) return false;
  }
  const bool flat = proposed.flat_low || proposed.flat_high;
  edge_ = {star_.kept(), star_.removed(), proposed.position};
  if (!legality_.keeps_faces(star_, edge_)) {
    if (hub || !proposed.flat_low || !proposed.flat_high) return false;
    // Nothing is lost at the other end either.
    const Point& other = mesh_.position(high);
    edge_.position = edge_.position == other ? mesh_.position(low) : other;
    if (!legality_.keeps_faces(star_, edge_)) return false;
  }
  cost_ = proposed.cost;
  const double closer = witnesses_.cost(edge_, star_, cost_, flat);
  return !(closer > cost_) || closer < closer_bound * bound;
}

unsigned Sweeps::collapse(const Collapse& edge, double cost) {
  const auto [kept, removed, position] = edge;
  witnesses_.collapsing(edge);
  highest_ = std::max(highest_, cost);
  const double weight = weight_of(planes_[kept]) + weight_of(planes_[removed]);
  if (weight > 0) largest_square_ = std::max(largest_square_, cost / weight);
  // Into a hub, which stays, any number may be collapsed.
  if (!mesh_.hub(kept)) state_[kept] = position == mesh_.position(kept) ? kept_in_place : moved;
  state_[removed] = gone;
  into_[removed] = kept;
  at_boundary_[kept] |= at_boundary_[removed];
  mesh_.move(kept, position);
  const auto faces = star_.faces();
  for (std::size_t i = 0; i < faces.size() && !coarse_; ++i) {
    const VertexPlanes change = star_.change(i);
    add(planes_[faces[i].w], change);
    add(planes_[faces[i].x], change);
  }
  const auto goes = [](const StarFace& face) { return !face.stays; };
  return static_cast<unsigned>(std::count_if(faces.begin(), faces.end(), goes));
}

// After a sweep.
void Sweeps::rewrite_faces() {
  std::size_t count = 0;
  for (const SurvivingFace& face : faces_) {
    const auto [a, b, c] = face.vertices;
    const FaceVertices now{into_[a], into_[b], into_[c]};
    faces_[count] = {now, face.number};
    count += static_cast<std::size_t>((now[0] != now[1]) & (now[1] != now[2]) & (now[2] != now[0]));
  }
  faces_.resize(count);
  corners_.make(std::span<const SurvivingFace>(faces_));
  std::erase_if(vertices_, [this](VertexNumber v) {
    const bool is_gone = state_[v] == gone;
    state_[v] = untouched;
    if (mesh_.hub(v)) mesh_.update_hub(v, corners_.degree(v));
    return is_gone || corners_.degree(v) == 0;
  });
}

}  // namespace winnow
