#include "decimate/sequence_decimation.hpp"

#include "decimate/frame_quadrics.hpp"
#include "decimate/sequence_cost.hpp"

namespace winnow {

namespace {

class SequenceDecimation final : public Decimation {
 public:
  SequenceDecimation(TileMesh& mesh, std::span<const std::byte> state,
                     const DecimationSettings& settings)
      : mesh_(mesh),
        rules_{settings.least_cosine, settings.rounding_of_positions(), settings.keep_pieces},
        legality_(mesh, settings.least_cosine),
        star_(settings.rounding_of_positions()),
        frames_(mesh, state,
                settings.boundaries_known ? Decimation::state_size(settings)
                                          : Decimation::first_state_size(settings),
                settings.sequence->frames),
        cost_(mesh, frames_, state, settings) {}

  void run(const CollapseLimits& limits, const std::function<void(const DoneCollapse&)>& done,
           const std::function<void()>& turn) override {
    Collapser<SequenceCost> collapser(mesh_, cost_, rules_);
    collapser.run(limits, counting(mesh_, done), turn);
    add(collapser.changes());
  }
  void repeat(std::span<const Collapse> edges) override {
    for (const Collapse& edge : edges) {
      if (edge.of_piece()) {
        repeat_piece(mesh_, edge.kept);
        continue;
      }
      star_.find(mesh_, edge.kept, edge.removed);
      cost_.repeat(edge, legality_, star_);
    }
  }
  void save(VertexNumber v, std::byte* into) const override {
    frames_.save(v, into);
    cost_.save(v, into + Frames::saved_size(frames_.count()));
  }
  [[nodiscard]] double largest_error() const override { return cost_.largest_error(); }

 private:
  TileMesh& mesh_;
  CollapseRules rules_;
  Legality legality_;
  EdgeStar star_;
  Frames frames_;
  SequenceCost cost_;
};

}  // namespace

std::unique_ptr<Decimation> make_sequence_decimation(TileMesh& mesh,
                                                     std::span<const std::byte> state,
                                                     const DecimationSettings& settings) {
  return std::make_unique<SequenceDecimation>(mesh, state, settings);
}

std::uint64_t sequence_decimation_memory(const SequenceSettings& settings, std::uint64_t vertices) {
  return Collapser<SequenceCost>::memory(vertices) + Frames::memory(settings.frames, vertices) +
         quadrics_memory(settings, vertices);
}

}  // namespace winnow
