#include "progressive/recorded_collapse.hpp"

#include <algorithm>

namespace winnow {

namespace {

template <std::size_t size>
std::size_t words_of(const std::vector<std::array<std::uint32_t, size>>& items) {
  return 1 + size * items.size();
}

template <std::size_t size>
std::uint32_t* put(const std::vector<std::array<std::uint32_t, size>>& items, std::uint32_t* at) {
  *at++ = static_cast<std::uint32_t>(items.size());
  for (const auto& item : items) at = std::copy(item.begin(), item.end(), at);
  return at;
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
  const std::uint32_t* at = words.data();
  for (auto& item : items)
    for (std::uint32_t& word : item) word = *at++;
  words = words.subspan(size * items.size());
}

void skip(std::span<const std::uint32_t>& words, std::size_t size) {
  const std::size_t count = take(words);
  words = words.subspan(size * count);
}

}  // namespace

void pack(const RecordedCollapse& collapse, Words& out) {
  const RingedSplit& ringed = collapse.ringed;
  const std::size_t before = out.size();
  out.resize(before + 3 + collapse.gone.size() + ringed.split.words.size() + ringed.before.size() +
             words_of(ringed.split.restored) + words_of(ringed.ring) +
             (ringed.ring.empty() ? words_of(ringed.split.moved) : 1));
  std::uint32_t* at = out.data() + before;
  *at++ = ringed.split.anchor;
  *at++ = ringed.split.moves ? 1 : 0;
  *at++ = static_cast<std::uint32_t>(collapse.gone.size());
  for (const std::vector<std::uint32_t>* list :
       {&collapse.gone, &ringed.split.words, &ringed.before})
    at = std::copy(list->begin(), list->end(), at);
  at = put(ringed.split.restored, at);
  at = put(ringed.ring, at);
  if (ringed.ring.empty()) {
    put(ringed.split.moved, at);
  } else {
    *at = static_cast<std::uint32_t>(ringed.split.moved.size());
  }
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
  take(words, ringed.split.restored);
  take(words, ringed.ring);
  if (ringed.ring.empty()) {
    take(words, ringed.split.moved);
  } else {
    ringed.split.moved.resize(take(words));
    ringed.take_moved();
  }
}

void skip_packed(std::span<const std::uint32_t>& words, std::size_t width) {
  const std::size_t moves = words[1], gone = words[2];
  words = words.subspan(3 + gone + width * (gone + 2 * moves));
  skip(words, 3);
  const bool rings = words[0] != 0;
  skip(words, 2);
  skip(words, rings ? 0 : 2);
}

}  // namespace winnow
