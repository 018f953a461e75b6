#include "progressive/split_codec.hpp"

#include <winnow/error.hpp>

#include "progressive/deflate.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

namespace {

// Kinds of splits. Of all but the last two the anchor moves, one vertex is new, and each face that
// comes back has the anchor, the new vertex and a neighbour of the anchor.
enum Kind : std::uint8_t {
  // The faces that move are side by side, from b to a.
  both_sides,  // anchor, new, a; new, anchor, b
  left_side,   // anchor, new, a
  right_side,  // new, anchor, b
  // A bit for each face says whether it moves.
  no_side_by_bits,  // the surface comes apart
  both_sides_by_bits,
  left_side_by_bits,
  right_side_by_bits,
  // Of any other all numbers are told.
  one_by_one,  // the anchor, if any, stays where it is
  one_by_one_that_moves
};

[[noreturn]] void refuse() {
  throw Error(ErrorKind::bad_input, "a chunk of splits is damaged");
}

std::uint32_t zigzag(std::uint32_t difference) {
  return (difference << 1) ^ (0U - (difference >> 31));
}
std::uint32_t unzigzag(std::uint32_t coded) {
  return (coded >> 1) ^ (0U - (coded & 1));
}

void put_varint(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<std::uint8_t>(value | 0x80));
  out.push_back(static_cast<std::uint8_t>(value));
}

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (unsigned i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

// Byte i of all values, then byte i + 1 of all.
void put_planes(std::vector<std::uint8_t>& out, std::span<const std::uint32_t> values,
                unsigned bytes = 4) {
  out.resize(out.size() + bytes * values.size());
  std::uint8_t* at = out.data() + out.size() - bytes * values.size();
  for (unsigned i = 0; i < bytes; ++i)
    for (const std::uint32_t value : values) *at++ = static_cast<std::uint8_t>(value >> 8 * i);
}

unsigned bytes_for(std::size_t numbers) {
  return numbers <= 0x100 ? 1 : numbers <= 0x10000 ? 2 : numbers <= 0x1000000 ? 3 : 4;
}

// What word `k` of the vertex whose words begin at `first` is likely to be.
std::uint32_t expected_word(const Split& split, std::span<const std::uint32_t> before,
                            std::size_t first, std::size_t k, std::size_t width) {
  if (split.moves && first == 0) return before[k];
  // As far on the other side.
  if (split.moves && first == width) return 2 * before[k] - split.words[k];
  return first > 0 ? split.words[first - width + k] : 0;
}

}  // namespace

void SplitEncoder::add(const RingedSplit& ringed) {
  if (!add_beside(ringed)) add_one_by_one(ringed);
  add_values(ringed);
}

// The neighbours in the faces that come back: false where these are others.
bool SplitEncoder::find_sides(const RingedSplit& ringed, std::uint32_t& left,
                              std::uint32_t& right) const {
  const Split& split = ringed.split;
  left = right = no_number;
  for (FaceVertices face : split.restored) {
    auto* const at = std::find(face.begin(), face.end(), split.anchor);
    if (at == face.end()) return false;
    std::rotate(face.begin(), at, face.end());
    const bool on_left = face[1] == ringed.first_new;
    if (!on_left && face[2] != ringed.first_new) return false;
    std::uint32_t& side = on_left ? left : right;
    if (side != no_number) return false;
    side = on_left ? face[2] : face[1];
    const auto has_side = [side](const FarEdge& far) { return far[0] == side || far[1] == side; };
    if (std::none_of(ringed.ring.begin(), ringed.ring.end(), has_side)) return false;
  }
  return true;
}

void SplitEncoder::gather_ring(const RingedSplit& ringed) {
  ring_.clear();
  for (const FarEdge& far : ringed.ring) ring_.add(far);
}

// Finds the faces that move side by side; false where they do not.
bool SplitEncoder::find_walk(const RingedSplit& ringed, std::uint32_t left, std::uint32_t right) {
  const std::vector<FarEdge>& moved = ringed.split.moved;
  const auto leads_to = [&](std::uint32_t v) {
    return std::any_of(moved.begin(), moved.end(), [v](const FarEdge& far) { return far[1] == v; });
  };
  // Of a closed fan it begins at the right neighbour, else where none leads to.
  const auto first = std::find_if(moved.begin(), moved.end(), [&](const FarEdge& far) {
    return right != no_number ? far[0] == right : !leads_to(far[0]);
  });
  if (first == moved.end()) return false;
  first_place_ = ring_.place_of(*first);
  if (first_place_ == ring_.size()) return false;
  ring_.walk(first_place_, moved.size(), places_);
  return (left == no_number || ring_.second(places_.back()) == left) && moves_those(ringed);
}

// Whether the faces at places_, which differ, are those that move.
bool SplitEncoder::moves_those(const RingedSplit& ringed) const {
  const std::vector<FarEdge>& moved = ringed.split.moved;
  return places_.size() == moved.size() &&
         std::all_of(places_.begin(), places_.end(), [&](std::uint32_t place) {
           const FarEdge far{ring_.first(place), ring_.second(place)};
           return std::find(moved.begin(), moved.end(), far) != moved.end();
         });
}

bool SplitEncoder::add_beside(const RingedSplit& ringed) {
  const Split& split = ringed.split;
  if (!split.moves || split.new_vertices != 1 || split.restored.size() > 2) return false;
  if (ringed.ring.empty() || ringed.ring.size() > most_ring_faces) return false;
  std::uint32_t left = no_number, right = no_number;
  if (!find_sides(ringed, left, right)) return false;
  gather_ring(ringed);
  const bool both = left != no_number && right != no_number;
  if ((left != no_number || right != no_number) && find_walk(ringed, left, right)) {
    kinds_.push_back(both ? both_sides : left != no_number ? left_side : right_side);
    rings_.push_back(static_cast<std::uint8_t>(ring_.rank_of(first_place_)));
    counts_.push_back(static_cast<std::uint8_t>(split.moved.size()));
  } else {
    ring_.sort();
    if (!add_bits(ringed)) return false;
    ring_.find_neighbours(neighbours_);
    kinds_.push_back(both                 ? both_sides_by_bits
                     : left != no_number  ? left_side_by_bits
                     : right != no_number ? right_side_by_bits
                                          : no_side_by_bits);
    for (const std::uint32_t side : {left, right}) {
      if (side == no_number) continue;
      const auto at = std::lower_bound(neighbours_.begin(), neighbours_.end(), side);
      rings_.push_back(static_cast<std::uint8_t>(at - neighbours_.begin()));
    }
  }
  anchors_.push_back(split.anchor);
  return true;
}

// Of equal faces the first ones move.
bool SplitEncoder::add_bits(const RingedSplit& ringed) {
  std::vector<FarEdge> left = ringed.split.moved;
  std::vector<std::uint8_t> bits((ring_.size() + 7) / 8);
  for (std::size_t i = 0; i < ring_.size() && !left.empty(); ++i) {
    const auto at = std::find(left.begin(), left.end(), FarEdge{ring_.first(i), ring_.second(i)});
    if (at == left.end()) continue;
    bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | 1U << i % 8);
    left.erase(at);
  }
  if (!left.empty()) return false;
  counts_.insert(counts_.end(), bits.begin(), bits.end());
  return true;
}

void SplitEncoder::add_one_by_one(const RingedSplit& ringed) {
  const Split& split = ringed.split;
  kinds_.push_back(split.moves ? one_by_one_that_moves : one_by_one);
  put_varint(varints_, split.anchor + 1);  // 0: none
  put_varint(varints_, split.new_vertices);
  put_varint(varints_, static_cast<std::uint32_t>(split.moved.size()));
  put_varint(varints_, static_cast<std::uint32_t>(split.restored.size()));
  std::uint32_t last = ringed.first_new;
  const auto put = [&](const auto& corners) {
    for (const std::uint32_t v : corners) put_varint(varints_, zigzag(v - std::exchange(last, v)));
  };
  for (const FarEdge& far : split.moved) put(far);
  for (const FaceVertices& face : split.restored) put(face);
}

void SplitEncoder::add_values(const RingedSplit& ringed) {
  const Split& split = ringed.split;
  for (std::size_t first = 0; first < split.words.size(); first += width_) {
    for (std::size_t k = 0; k < width_; ++k) {
      const std::uint32_t expected = expected_word(split, ringed.before, first, k, width_);
      values_[k].push_back(zigzag(split.words[first + k] - expected));
    }
  }
}

std::vector<std::byte> SplitEncoder::finish(std::uint32_t& raw_bytes) {
  std::vector<std::uint32_t> table = anchors_;
  std::sort(table.begin(), table.end());
  table.erase(std::unique(table.begin(), table.end()), table.end());
  std::vector<std::uint8_t> anchors;
  put_varint(anchors, static_cast<std::uint32_t>(table.size()));
  std::uint32_t before = 0;
  for (const std::uint32_t anchor : table)
    put_varint(anchors, anchor - std::exchange(before, anchor));
  for (std::uint32_t& anchor : anchors_)
    anchor = static_cast<std::uint32_t>(std::lower_bound(table.begin(), table.end(), anchor) -
                                        table.begin());
  put_planes(anchors, anchors_, bytes_for(table.size()));
  std::vector<std::uint8_t> raw;
  std::vector<std::size_t> ends;
  for (const std::vector<std::uint8_t>* section :
       {&kinds_, &anchors, &rings_, &counts_, &varints_}) {
    put_u32(raw, static_cast<std::uint32_t>(section->size()));
    raw.insert(raw.end(), section->begin(), section->end());
    ends.push_back(raw.size());
  }
  for (const Words& values : values_) {
    put_planes(raw, values);
    for (std::size_t left = 4; left-- > 0;) ends.push_back(raw.size() - left * values.size());
  }
  raw_bytes = static_cast<std::uint32_t>(raw.size());
  *this = SplitEncoder(width_);
  return deflated(raw, ends);
}

std::uint8_t SplitDecoder::Bytes::byte() {
  if (at == end) refuse();
  return *at++;
}

std::uint32_t SplitDecoder::Bytes::varint() {
  std::uint32_t value = 0;
  for (unsigned shift = 0; shift < 35; shift += 7) {
    const std::uint8_t part = byte();
    if (shift == 28 && part > 15) refuse();
    value |= static_cast<std::uint32_t>(part & 0x7F) << shift;
    if (part < 0x80) return value;
  }
  refuse();
}

SplitDecoder::Bytes SplitDecoder::section() {
  if (rest_.end - rest_.at < 4) refuse();
  std::uint32_t size = 0;
  for (unsigned i = 0; i < 4; ++i) size |= static_cast<std::uint32_t>(rest_.byte()) << 8 * i;
  if (size > static_cast<std::size_t>(rest_.end - rest_.at)) refuse();
  const Bytes part{rest_.at, rest_.at + size};
  rest_.at += size;
  return part;
}

SplitDecoder::SplitDecoder(std::span<const std::byte> packed, std::uint32_t raw_bytes,
                           std::uint32_t splits, std::size_t width)
    : raw_(inflated(packed, raw_bytes, most_chunk_bytes)), width_(width), splits_(splits) {
  rest_ = {raw_.data(), raw_.data() + raw_.size()};
  kinds_ = section();
  const Bytes anchors = section();
  rings_ = section();
  counts_ = section();
  varints_ = section();
  if (kinds_.left() != splits || rest_.left() % (4 * width) != 0) refuse();
  read_anchors(anchors);
  read_words(rest_.left() / (4 * width));
}

void SplitDecoder::read_words(std::size_t rows) {
  differences_.resize(rows * width_);
  for (std::size_t k = 0; k < width_; ++k) {
    const std::uint8_t* byte = rest_.at + 4 * k * rows;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::uint32_t coded = std::uint32_t{byte[row]} | std::uint32_t{byte[rows + row]} << 8 |
                                  std::uint32_t{byte[2 * rows + row]} << 16 |
                                  std::uint32_t{byte[3 * rows + row]} << 24;
      differences_[row * width_ + k] = unzigzag(coded);
    }
  }
}

void SplitDecoder::read_anchors(Bytes bytes) {
  const std::uint32_t numbers = bytes.varint();
  if (numbers > bytes.left()) refuse();
  std::vector<std::uint32_t> table(numbers);
  std::uint32_t before = 0;
  for (std::uint32_t& number : table) number = before += bytes.varint();
  const unsigned planes = bytes_for(numbers);
  if (bytes.left() % planes != 0) refuse();
  anchors_.resize(bytes.left() / planes);
  for (std::size_t i = 0; i < anchors_.size(); ++i) {
    std::uint32_t index = 0;
    for (unsigned k = 0; k < planes; ++k)
      index |= static_cast<std::uint32_t>(bytes.at[k * anchors_.size() + i]) << 8 * k;
    if (index >= numbers) refuse();
    anchors_[i] = table[index];
  }
}

void SplitDecoder::next(const SplitMesh& mesh, Split& split) {
  split.clear();
  const unsigned kind = kinds_.byte();
  ++done_;
  if (kind < one_by_one) {
    beside(mesh, kind, split);
  } else if (kind <= one_by_one_that_moves) {
    tell_one_by_one(mesh, kind == one_by_one_that_moves, split);
  } else {
    refuse();
  }
  values(mesh, split);
}

void SplitDecoder::beside(const SplitMesh& mesh, unsigned kind, Split& split) {
  if (anchor_ == anchors_.size()) refuse();
  ahead_.go_to(mesh, anchor_, anchors_.size(), [this](std::size_t i) { return anchors_[i]; });
  split.anchor = anchors_[anchor_++];
  if (split.anchor >= mesh.vertices()) refuse();
  split.moves = true;
  split.new_vertices = 1;
  mesh.find_ring(split.anchor, ring_);
  if (ring_.size() > most_ring_faces) refuse();
  std::uint32_t left = no_number, right = no_number;
  if (kind < no_side_by_bits) {
    take_walk(split);
    if (kind != right_side) left = ring_.second(places_.back());
    if (kind != left_side) right = ring_.first(places_.front());
  } else {
    ring_.sort();
    take_bits(split);
    ring_.find_neighbours(neighbours_);
    if (kind == both_sides_by_bits || kind == left_side_by_bits) left = take_neighbour();
    if (kind == both_sides_by_bits || kind == right_side_by_bits) right = take_neighbour();
  }
  const std::uint32_t added = mesh.vertices();
  if (left != no_number) split.restored.push_back({split.anchor, added, left});
  if (right != no_number) split.restored.push_back({added, split.anchor, right});
}

std::uint32_t SplitDecoder::take_neighbour() {
  const std::uint8_t number = rings_.byte();
  if (number >= neighbours_.size()) refuse();
  return neighbours_[number];
}

// Faces side by side.
void SplitDecoder::take_walk(Split& split) {
  const std::uint8_t first = rings_.byte();
  const std::uint8_t count = counts_.byte();
  if (first >= ring_.size() || count == 0) refuse();
  ring_.walk(ring_.place_of(first), count, places_);
  if (places_.size() < count) refuse();
  for (std::size_t i = 0; i < ring_.size(); ++i) split.around.push_back({ring_.corner(i), 0});
  for (const std::uint32_t place : places_) split.around[place].moves = 1;
}

void SplitDecoder::take_bits(Split& split) {
  std::uint8_t bits = 0;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    if (i % 8 == 0) bits = counts_.byte();
    split.around.push_back({ring_.corner(i), std::uint32_t{bits} >> i % 8 & 1});
  }
}

void SplitDecoder::tell_one_by_one(const SplitMesh& mesh, bool moves, Split& split) {
  split.moves = moves;
  split.anchor = varints_.varint() - 1;
  split.new_vertices = varints_.varint();
  const std::uint32_t moved = varints_.varint();
  const std::uint32_t restored = varints_.varint();
  if (std::uint64_t{2} * moved + std::uint64_t{3} * restored > varints_.left()) refuse();
  std::uint32_t last = mesh.vertices();
  const auto take = [&](auto& corners) {
    for (std::uint32_t& v : corners) v = last += unzigzag(varints_.varint());
  };
  split.moved.resize(moved);
  for (FarEdge& far : split.moved) take(far);
  split.restored.resize(restored);
  for (FaceVertices& face : split.restored) take(face);
}

void SplitDecoder::values(const SplitMesh& mesh, Split& split) {
  if (split.moves && split.anchor >= mesh.vertices()) refuse();
  const std::size_t count = std::size_t{split.new_vertices} + split.moves;
  if (count > differences_.size() / width_ - row_) refuse();
  split.words.resize(count * width_);
  const std::span<const std::uint32_t> before =
      split.moves ? mesh.words(split.anchor) : std::span<const std::uint32_t>{};
  const std::uint32_t* const difference = differences_.data() + row_ * width_;
  for (std::size_t first = 0; first < split.words.size(); first += width_) {
    for (std::size_t k = 0; k < width_; ++k)
      split.words[first + k] =
          expected_word(split, before, first, k, width_) + difference[first + k];
  }
  row_ += count;
}

}  // namespace winnow
