#include "stitch/tried_tiles.hpp"

#include <cstring>
#include <span>

namespace winnow {

namespace {

struct Head {
  std::uint64_t edges, frozen;
  double reached;
};

}  // namespace

TriedTiles::TriedTiles(const CheckpointDirectory* checkpoint, std::uint64_t round,
                       unsigned attempt) {
  if (checkpoint == nullptr) return;
  journal_ = std::make_unique<Journal>(
      checkpoint->file("round-" + std::to_string(round) + ".attempt-" + std::to_string(attempt)));
}

bool TriedTiles::next(TriedTile& tile) {
  if (journal_ == nullptr || !journal_->next(record_)) return false;
  Head head{};
  if (record_.size() < sizeof head) return false;
  std::memcpy(&head, record_.data(), sizeof head);
  const std::size_t rest = record_.size() - sizeof head;
  if (rest % CollapseLog::entry_size != 0 || rest / CollapseLog::entry_size != head.edges)
    return false;
  tile.edges.resize(head.edges);
  tile.costs.resize(head.edges);
  tile.frozen = head.frozen;
  tile.reached = head.reached;
  if (head.edges == 0) return true;
  const std::byte* edges = record_.data() + sizeof head;
  std::memcpy(tile.edges.data(), edges, head.edges * sizeof(Collapse));
  std::memcpy(tile.costs.data(), edges + head.edges * sizeof(Collapse),
              head.edges * sizeof(CollapseLog::Cost));
  return true;
}

void TriedTiles::append(const TriedTile& tile) {
  if (journal_ == nullptr) return;
  const Head head{tile.edges.size(), tile.frozen, tile.reached};
  journal_->append({std::as_bytes(std::span(&head, 1)), std::as_bytes(std::span(tile.edges)),
                    std::as_bytes(std::span(tile.costs))});
}

}  // namespace winnow
