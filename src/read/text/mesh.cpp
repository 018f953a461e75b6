#include "read/text/mesh.hpp"

#include <winnow/error.hpp>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "read/for_each_batch.hpp"
#include "read/text/decimal.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

namespace winnow {

namespace {

constexpr std::size_t corners_between_questions = 1 << 16;

}  // namespace

ParsedLines::ParsedLines(const TextBlock& block, const BufferedMesh& mesh)
    : block_(block), mesh_(mesh) {
  // A vector that grows would hold three times as much.
  if (block.long_line) corners_.reserve(block.text().size() / 2);
}

void ParsedLines::add_position(LineWords& words) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words.next();
    const std::optional<double> value = parse_real(word);
    if (!value) fail_number(word, words.rest());
    single_ = single_ && float_says_it(word, *value);
    xyz_.push_back(*value);
  }
}

void ParsedLines::add_attributes(LineWords& words, bool required) {
  for (const bool carried : mesh_.carried()) {
    const std::string_view word = words.next();
    if (!carried) continue;
    const std::optional<double> value = parse_real(word);
    if (!value && (required || !word.empty())) fail_number(word, words.rest());
    some_lack_attributes_ |= !value;
    attributes_.push_back(value.value_or(0));
  }
}

void ParsedLines::add_corner(std::int64_t vertex, bool relative) {
  corners_.push_back(2 * std::clamp<std::int64_t>(vertex, -1 - std::int64_t{no_vertex}, no_vertex) +
                     (relative ? 1 : 0));
  if (++open_ % corners_between_questions == 0) mesh_.job().progress.check_cancelled();
}

void ParsedLines::end_face() {
  sizes_.push_back(open_);
  open_ = 0;
}

void ParsedLines::pass_over(const char* what) {
  if (std::find(passed_over_.begin(), passed_over_.end(), what) == passed_over_.end())
    passed_over_.push_back(what);
}

void ParsedLines::fail(std::string_view place, const std::string& what) const {
  throw Error(ErrorKind::bad_input,
              "'" + mesh_.name() + "', line " + grouped(block_.line_of(place)) + ": " + what);
}

void ParsedLines::fail_number(std::string_view word, std::string_view place) const {
  if (word.empty()) fail(place, "a number is missing; the file was cut short, or is damaged");
  fail(word, not_a_number(word));
}

void ParsedLines::hand_over(BufferedMesh& mesh) const {
  const auto base = static_cast<std::int64_t>(mesh.vertices());
  mesh.add_vertices(xyz_, single_, attributes_);
  if (some_lack_attributes_) mesh.drop_attributes();
  mesh.add_numbers(numbers_);
  for (const char* what : passed_over_) mesh.pass_over(what);
  std::vector<std::uint32_t> polygon;
  std::size_t at = 0;
  for (const std::uint32_t size : sizes_) {
    polygon.clear();
    polygon.reserve(size);
    for (const std::size_t end = at + size; at < end; ++at) {
      if ((at + 1) % corners_between_questions == 0) mesh.job().progress.check_cancelled();
      const std::int64_t vertex = (corners_[at] >> 1) + ((corners_[at] & 1) != 0 ? base : 0);
      polygon.push_back(vertex < 0 || vertex > no_vertex ? no_vertex
                                                         : static_cast<std::uint32_t>(vertex));
    }
    mesh.add_polygon(polygon);
  }
}

namespace {

struct Item {
  TextBlock block;
  std::optional<ParsedLines> lines;
  std::optional<Error> error;
};

}  // namespace

std::string first_lines(ByteSource& source) {
  const Block head = source.peek(text_head_bytes);
  std::string_view text(reinterpret_cast<const char*>(head.bytes.data()), head.bytes.size());
  // The last line may be cut.
  if (text.size() == text_head_bytes) text = text.substr(0, text.find_last_of("\r\n") + 1);
  return std::string(without_byte_order_mark(text));
}

void parse_text(const TextParser& parser, BufferedMesh& mesh) {
  std::optional<TextBlock> alone;
  std::exception_ptr failure;
  const auto fill = [&](Item& item) {
    try {
      if (!parser.next(item.block)) return false;
    } catch (const Error&) {
      failure = std::current_exception();  // what is wrong before it comes first
      return false;
    }
    if (!item.block.long_line) return true;
    alone = std::exchange(item.block, {});
    return false;
  };
  const auto parse = [&](Item& item) {
    item.lines.emplace(item.block, mesh);
    item.error.reset();
    try {
      parser.parse(item.block, *item.lines);
    } catch (const Error& error) {
      item.error = error;
    }
    item.block.block.check_intact(mesh.name());
  };
  // Of several wrong lines the first is told.
  const auto hand_over = [&](Item& item) {
    if (item.error) throw Error(*item.error);
    item.lines->hand_over(mesh);
    mesh.job().progress.advance(item.block.block.bytes.size());
    item.lines.reset();
    item.block = {};
  };
  for (;;) {
    pipeline<Item>(batches_in_flight(mesh.job().threads), fill, parse, hand_over);
    if (failure) std::rethrow_exception(failure);
    if (!alone) break;
    Item item{*std::exchange(alone, {}), {}, {}};
    parse(item);
    hand_over(item);
  }
}

}  // namespace winnow
