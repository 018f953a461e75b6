#include "decimate/decimation.hpp"

#include "base/cell_state.hpp"
#include "base/rounding.hpp"
#include "decimate/error_bound.hpp"
#include "decimate/frame_quadrics.hpp"
#include "decimate/frames.hpp"
#include "decimate/importance_cost.hpp"
#include "decimate/quadric_cost.hpp"
#include "decimate/quadric_placement.hpp"
#include "decimate/sequence_decimation.hpp"
#include "decimate/sweeps.hpp"
#include "decimate/volume_cost.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace winnow {

namespace {

CollapseRules rules_of(const DecimationSettings& settings) {
  const CoordinateRounding rounding = settings.rounding_of_positions();
  return {settings.least_cosine, rounding, settings.keep_pieces, settings.free_topology};
}

// By a cost function that knows the mesh alone: made when it is needed, by make(mesh); or by
// make(mesh, swept) where sweeps have been at the mesh, those of make.sweeps(mesh, rules).
template <typename MakeCost>
class MemorylessDecimation final : public Decimation {
 public:
  MemorylessDecimation(TileMesh& mesh, const DecimationSettings& settings, MakeCost make)
      : mesh_(mesh),
        settings_(settings),
        make_(std::move(make)),
        star_(settings.rounding_of_positions()) {}

  void run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done,
           const std::function<void()>& turn) override {
    if constexpr (requires { make_.sweeps(mesh_, rules_of(settings_)); }) {
      if (!settings_.free_topology) {
        std::optional<Swept> swept =
            sweep(make_.sweeps(mesh_, rules_of(settings_)), limits, done, turn);
        if (!swept) return;
        const double highest = swept->highest_cost;
        mesh_.link();
        return choose(make_(mesh_, std::move(*swept)), highest, limits, done, turn);
      }
    }
    mesh_.link();
    choose(make_(mesh_), 0, limits, done, turn);
  }
  void repeat(std::span<const Collapse> edges) override {
    const auto of_piece = [](const Collapse& edge) { return edge.of_piece(); };
    if (!mesh_.linked() && !settings_.free_topology &&
        std::none_of(edges.begin(), edges.end(), of_piece))
      return mesh_.collapse_all(edges);
    mesh_.link();
    for (const Collapse& edge : edges) repeat(edge);
  }
  void save(VertexNumber /*v*/, std::byte* /*into*/) const override {}
  [[nodiscard]] double largest_error() const override { return largest_error_; }

 private:
  // None where nothing is left to do.
  std::optional<Swept> sweep(Sweeps sweeps, const CollapseLimits& limits,
                             const std::function<void(const DoneCollapse&)>& done,
                             const std::function<void()>& turn) {
    const bool ready = sweeps.run(limits, done, turn);
    largest_error_ = std::sqrt(sweeps.largest_square());
    if (ready) return std::nullopt;
    return std::move(sweeps).hand_on();
  }
  // In the order of costs.
  template <typename Cost>
  void choose(Cost cost, double highest, const CollapseLimits& limits,
              const std::function<void(const DoneCollapse&)>& done,
              const std::function<void()>& turn) {
    Collapser collapser(mesh_, cost, rules_of(settings_), highest);
    collapser.run(limits, counting(mesh_, done), turn);
    add(collapser.changes());
    largest_error_ = cost.largest_error();
  }
  void repeat(const Collapse& edge) {
    if (edge.of_piece()) {
      repeat_piece(mesh_, edge.kept);
      return;
    }
    if (settings_.free_topology) {
      star_.find(mesh_, edge.kept, edge.removed);
      const bool changes = find_change(mesh_, star_, change_);
      mesh_.collapse(edge);
      gone_.clear();
      if (changes) mesh_.remove_pairs(edge.kept, gone_);
    } else {
      mesh_.collapse(edge);
    }
  }

  TileMesh& mesh_;
  DecimationSettings settings_;
  MakeCost make_;
  EdgeStar star_;
  SurfaceChange change_;
  std::vector<FaceVertices> gone_;
  double largest_error_ = 0;
};

template <typename MakeCost>
std::unique_ptr<Decimation> memoryless(TileMesh& mesh, const DecimationSettings& settings,
                                       MakeCost make) {
  return std::make_unique<MemorylessDecimation<MakeCost>>(mesh, settings, std::move(make));
}

struct MakeQuadricCost {
  bool single;
  CoordinateRounding rounding;

  QuadricCost operator()(TileMesh& mesh) const { return QuadricCost(mesh, single, rounding); }
  QuadricCost operator()(TileMesh& mesh, Swept swept) const {
    return QuadricCost(mesh, single, rounding, std::move(swept.witnesses), swept.largest_square);
  }
  [[nodiscard]] Sweeps sweeps(TileMesh& mesh, const CollapseRules& rules) const {
    return Sweeps(mesh, single, rules);
  }
};

// By a cost function that remembers.
template <typename Cost>
class AccumulatingDecimation final : public Decimation {
 public:
  template <typename... Arguments>
  AccumulatingDecimation(TileMesh& mesh, const DecimationSettings& settings,
                         Arguments&&... arguments)
      : mesh_(mesh),
        settings_(settings),
        star_(settings.rounding_of_positions()),
        cost_(mesh, std::forward<Arguments>(arguments)...) {}

  void run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done,
           const std::function<void()>& turn) override {
    Collapser<Cost> collapser(mesh_, cost_, rules_of(settings_));
    collapser.run(limits, counting(mesh_, done), turn);
    add(collapser.changes());
  }
  void repeat(std::span<const Collapse> edges) override {
    for (const Collapse& edge : edges) repeat(edge);
  }
  void repeat(const Collapse& edge) {
    if (edge.of_piece()) {
      repeat_piece(mesh_, edge.kept);
      return;
    }
    star_.find(mesh_, edge.kept, edge.removed);
    const bool changes = settings_.free_topology && find_change(mesh_, star_, change_);
    cost_.repeat(edge, star_, changes ? &change_ : nullptr);
    if (!changes) return;
    gone_.clear();
    mesh_.remove_pairs(edge.kept, gone_);
    cost_.faces_gone(gone_);
  }
  void save(VertexNumber v, std::byte* into) const override {
    const typename Cost::State state = cost_.state(v);
    std::memcpy(into, &state, sizeof state);
  }
  [[nodiscard]] double largest_error() const override { return cost_.largest_error(); }

 private:
  TileMesh& mesh_;
  DecimationSettings settings_;
  EdgeStar star_;
  SurfaceChange change_;
  std::vector<FaceVertices> gone_;
  Cost cost_;
};

// Repeats what any cost has chosen, and watches what error it needs.
class WatchingDecimation final : public Decimation {
 public:
  WatchingDecimation(TileMesh& mesh, const DecimationSettings& settings,
                     std::vector<ErrorBound::State> states)
      : mesh_(mesh),
        free_topology_(settings.free_topology),
        at_boundary_(mesh.vertex_count(), 0),
        star_(settings.rounding_of_positions()),
        bound_(mesh, std::numeric_limits<double>::infinity(), std::move(states), at_boundary_) {
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v)
      at_boundary_[v] = !mesh.all_edges_even(v);
  }

  void run(const CollapseLimits& /*limits*/,
           const std::function<void(const DoneCollapse&)>& /*done*/,
           const std::function<void()>& /*turn*/) override {
    throw std::logic_error("what watches an error chooses no collapse");
  }
  void repeat(std::span<const Collapse> edges) override {
    for (const Collapse& edge : edges) repeat(edge);
  }
  void repeat(const Collapse& edge) {
    if (edge.of_piece()) {
      needed_error_ = bound_.needed(repeat_piece(mesh_, edge.kept));
      return;
    }
    // Inside of the surface planes tell all.
    const bool boundary = (at_boundary_[edge.kept] | at_boundary_[edge.removed]) != 0;
    if (boundary || free_topology_) star_.find(mesh_, edge.kept, edge.removed);
    const bool changes = free_topology_ && find_change(mesh_, star_, change_);
    (void)bound_.allows(edge, star_, changes ? &change_ : nullptr);
    needed_error_ = bound_.needed();
    if (changes) needed_error_ = std::max(needed_error_, bound_.needed(star_, change_));
    bound_.collapsing(edge);
    mesh_.collapse(edge);
    at_boundary_[edge.kept] |= at_boundary_[edge.removed];
    if (!changes) return;
    gone_.clear();
    mesh_.remove_pairs(edge.kept, gone_);
    for (const FaceVertices& face : gone_) {
      for (const VertexNumber v : face) {
        if (!mesh_.all_edges_even(v)) at_boundary_[v] = 1;
      }
    }
  }
  void save(VertexNumber v, std::byte* into) const override {
    std::memcpy(into, &bound_.state(v), sizeof(ErrorBound::State));
  }
  [[nodiscard]] double largest_error() const override { return bound_.largest_error(); }
  [[nodiscard]] double needed_error() const override { return needed_error_; }

 private:
  TileMesh& mesh_;
  bool free_topology_;
  std::vector<std::uint8_t> at_boundary_;
  EdgeStar star_;
  SurfaceChange change_;
  std::vector<FaceVertices> gone_;
  ErrorBound bound_;
  double needed_error_ = 0;
};

template <typename State>
std::vector<State> states_of(const TileMesh& mesh, std::span<const std::byte> bytes) {
  std::vector<State> states(mesh.vertex_count());
  if (!bytes.empty()) std::memcpy(states.data(), bytes.data(), bytes.size());
  return states;
}

void lock_boundaries(TileMesh& mesh) {
  Legality legality(mesh, 0);
  for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
    if (legality.at_boundary(v)) mesh.lock(v);
  }
}

// Before the first round, when the state is that of cells, if any.
std::vector<ErrorBound::State> first_bound_states(TileMesh& mesh, std::span<const std::byte> bytes,
                                                  const DecimationSettings& settings) {
  std::vector<ErrorBound::State> states(mesh.vertex_count());
  if (bytes.empty()) {
    ErrorBound::add_faces(mesh, settings.rounding_of_positions(), states);
  } else {
    const std::vector<CellState> cells = states_of<CellState>(mesh, bytes);
    for (VertexNumber v = 0; v < mesh.vertex_count(); ++v) {
      states[v].planes = cells[v].planes;
      states[v].low = cells[v].low;
      states[v].high = cells[v].high;
    }
  }
  ErrorBound::add_boundaries(mesh, states);
  return states;
}

bool bounds_error(const DecimationSettings& settings) {
  return facts_of(settings.cost).bounds_error && settings.error.has_value();
}

std::unique_ptr<Decimation> by_quadrics(TileMesh& mesh, std::span<const std::byte> state,
                                        const DecimationSettings& settings) {
  const CoordinateRounding rounding = settings.rounding_of_positions();
  if (bounds_error(settings)) {
    const auto within = [&](auto states) {
      return std::make_unique<AccumulatingDecimation<QuadricCost>>(
          mesh, settings, settings.single, rounding, *settings.error, std::move(states));
    };
    return settings.boundaries_known ? within(states_of<QuadricCost::State>(mesh, state))
                                     : within(first_bound_states(mesh, state, settings));
  }
  return memoryless(mesh, settings, MakeQuadricCost{settings.single, rounding});
}

// Bytes that collapsing by a cost takes besides what is remembered.
std::uint64_t memory_of(const DecimationSettings& settings, std::uint64_t vertices) {
  const std::uint64_t queue = Collapser<QuadricCost>::memory(vertices);
  switch (settings.cost) {
    case Refine::quadric: {
      const std::uint64_t with_quadrics = queue + QuadricCost::memory(vertices);
      const bool sweeps = !bounds_error(settings);
      return sweeps ? std::max(with_quadrics, Sweeps::memory(vertices)) : with_quadrics;
    }
    case Refine::volume:
    case Refine::importance:
    case Refine::none:
      break;
  }
  return queue;
}

}  // namespace

std::unique_ptr<Decimation> Decimation::make_watching(TileMesh& mesh,
                                                      std::span<const std::byte> state,
                                                      const DecimationSettings& settings) {
  mesh.link();
  if (settings.keep_boundaries) lock_boundaries(mesh);
  return std::make_unique<WatchingDecimation>(mesh, settings,
                                              settings.boundaries_known
                                                  ? states_of<ErrorBound::State>(mesh, state)
                                                  : first_bound_states(mesh, state, settings));
}

std::unique_ptr<Decimation> Decimation::make(TileMesh& mesh, std::span<const std::byte> state,
                                             const DecimationSettings& settings) {
  if (settings.keep_boundaries || bounds_error(settings) || settings.sequence) mesh.link();
  if (settings.keep_boundaries) lock_boundaries(mesh);
  if (settings.sequence) return make_sequence_decimation(mesh, state, settings);
  const double rounding = settings.rounding_of_positions().relative;
  const bool free = settings.free_topology;
  switch (settings.cost) {
    case Refine::quadric:
      return by_quadrics(mesh, state, settings);
    case Refine::volume:
      return memoryless(mesh, settings,
                        [rounding, free](TileMesh& of) { return VolumeCost(of, rounding, free); });
    case Refine::importance:
      return memoryless(mesh, settings, [rounding, free](TileMesh& of) {
        return ImportanceCost(of, rounding, free);
      });
    case Refine::none:
      break;
  }
  throw std::logic_error("no cost to decimate by");
}

bool Decimation::find_change(TileMesh& mesh, const EdgeStar& star, SurfaceChange& change) {
  Legality legality(mesh, 0);
  if (legality.keeps_surface(star) || !legality.find_change(star, change)) return false;
  add_change(mesh, star, change, changes_);
  return true;
}

const Piece& Decimation::repeat_piece(TileMesh& mesh, VertexNumber v) {
  piece_.find(mesh, v);
  changes_.add_piece(mesh, piece_);
  mesh.remove(piece_.vertices, piece_.faces);
  return piece_;
}

std::function<void(const DoneCollapse&)> Decimation::counting(
    TileMesh& mesh, const std::function<void(const DoneCollapse&)>& done) {
  return [this, &mesh, &done](const DoneCollapse& collapse) {
    if (collapse.edge.of_piece() && piece_.find(mesh, collapse.edge.kept))
      changes_.add_piece(mesh, piece_);
    done(collapse);
  };
}

std::size_t Decimation::first_state_size(const DecimationSettings& settings) {
  if (settings.sequence) return Frames::saved_size(settings.sequence->frames);
  return bounds_error(settings) ? sizeof(CellState) : state_size(settings);
}

std::size_t Decimation::state_size(const DecimationSettings& settings) {
  if (settings.sequence)
    return Frames::saved_size(settings.sequence->frames) + remembered_size(*settings.sequence);
  return bounds_error(settings) ? sizeof(QuadricCost::State) : 0;
}

std::size_t Decimation::watched_state_size() {
  return sizeof(ErrorBound::State);
}

std::uint64_t Decimation::memory(const DecimationSettings& settings, std::uint64_t vertices) {
  const std::uint64_t collapsing = settings.sequence
                                       ? sequence_decimation_memory(*settings.sequence, vertices)
                                       : memory_of(settings, vertices);
  return collapsing + vertices * state_size(settings);
}

}  // namespace winnow
