#include "progressive/recorded_collapse.hpp"

namespace winnow {

namespace {

template <std::size_t size>
void put(const std::vector<std::array<std::uint32_t, size>>& items, Words& out) {
  out.push_back(static_cast<std::uint32_t>(items.size()));
  for (const auto& item : items) out.insert(out.end(), item.begin(), item.end());
}

std::uint32_t take(std::span<const std::uint32_t>& words) {
  const std::uint32_t word = words.front();
  words = words.subspan(1);
  return word;
}

void take(std::span<const std::uint32_t>& words, std::size_t count,
          std::vector<std::uint32_t>& into) {
  into.assign(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count));
  words = words.subspan(count);
}

template <std::size_t size>
void take(std::span<const std::uint32_t>& words,
          std::vector<std::array<std::uint32_t, size>>& items) {
  items.resize(take(words));
  for (auto& item : items)
    for (std::uint32_t& word : item) word = take(words);
}

}  // namespace

void pack(const RecordedCollapse& collapse, Words& out) {
  const RingedSplit& ringed = collapse.ringed;
  out.push_back(ringed.split.anchor);
  out.push_back(ringed.split.moves ? 1 : 0);
  out.push_back(static_cast<std::uint32_t>(collapse.gone.size()));
  out.insert(out.end(), collapse.gone.begin(), collapse.gone.end());
  out.insert(out.end(), ringed.split.words.begin(), ringed.split.words.end());
  out.insert(out.end(), ringed.before.begin(), ringed.before.end());
  put(ringed.split.moved, out);
  put(ringed.split.restored, out);
  put(ringed.ring, out);
}

void unpack(std::span<const std::uint32_t>& words, std::size_t width, RecordedCollapse& collapse) {
  collapse.clear();
  RingedSplit& ringed = collapse.ringed;
  ringed.split.anchor = take(words);
  ringed.split.moves = take(words) != 0;
  ringed.split.new_vertices = take(words);
  take(words, ringed.split.new_vertices, collapse.gone);
  take(words, width * (std::size_t{ringed.split.new_vertices} + ringed.split.moves),
       ringed.split.words);
  if (ringed.split.moves) take(words, width, ringed.before);
  take(words, ringed.split.moved);
  take(words, ringed.split.restored);
  take(words, ringed.ring);
}

}  // namespace winnow
