// STL: binary (80 bytes of anything, a 32-bit count, 50 bytes a face) and ASCII.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "base/vector.hpp"
#include "read/foreign_formats.hpp"
#include "read/formats.hpp"
#include "read/indexed/slices.hpp"
#include "read/polygons/polygon_cutter.hpp"
#include "read/text/lines.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace winnow {

namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t face_bytes = 50;

struct StlHead {
  bool ascii = false;
  bool exact = false;                   // binary: the count must be right
  std::uint32_t declared = 0;           // binary only
  std::optional<std::uint64_t> stored;  // whole faces by the file's size, where that is known
};

constexpr auto equals_small = [](char a, char b) { return ascii_to_lower(a) == b; };

// `word` in small letters.
bool contains_word(std::string_view text, std::string_view word) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(), equals_small) !=
         text.end();
}

bool is_word(std::string_view word, std::string_view small) {
  return std::equal(word.begin(), word.end(), small.begin(), small.end(), equals_small);
}

// Any binary file could be an STL. Whether half of the faces that are looked at are of numbers that
// a model may have.
bool looks_like_faces(std::string_view head) {
  std::size_t faces = 0, likely = 0;
  for (std::size_t at = header_bytes; at + face_bytes <= head.size(); at += face_bytes) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), head.data() + at, sizeof numbers);
    ++faces;
    likely += std::all_of(numbers.begin(), numbers.end(), [](float x) {
      const float size = std::abs(x);
      return size == 0 || (size > 1e-30F && size < 1e30F);
    });
  }
  return 2 * likely >= faces;
}

// The field has 32 bits.
bool is_right_count(std::uint64_t declared, std::uint64_t faces) {
  return declared == faces || (declared == UINT32_MAX && faces > declared);
}

[[noreturn]] void refuse_count(const std::string& name, std::uint64_t declared,
                               std::uint64_t stored) {
  throw Error(ErrorKind::bad_input,
              "'" + name + "' is no mesh in a format that winnow reads, or a damaged " +
                  "STL: its header would say " + grouped(declared) +
                  " faces, and it has room for " + grouped(stored) +
                  "; `from` stl reads it all the same");
}

// What there is to decide by: whether the count fits the size, whether it reads like text. Many
// binary files begin with "solid" all the same.
StlHead look_at_head(ByteSource& source, bool asked) {
  const Block block = source.peek(1024);
  const std::string_view head(reinterpret_cast<const char*>(block.bytes.data()),
                              block.bytes.size());
  if (head.empty()) throw Error(ErrorKind::bad_input, "'" + source.name() + "' is empty");
  StlHead found;
  if (head.size() >= header_bytes)
    std::memcpy(&found.declared, head.data() + 80, sizeof found.declared);
  if (source.size() && *source.size() >= header_bytes)
    found.stored = (*source.size() - header_bytes) / face_bytes;
  if (has_size_of_binary_stl(source)) return found;
  const std::string wrong = "'" + source.name() + "' is no mesh in a format that winnow reads: ";
  if (is_text(head)) {
    const Block more = source.peek(text_head_bytes);
    const std::string_view text = without_byte_order_mark(
        {reinterpret_cast<const char*>(more.bytes.data()), more.bytes.size()});
    found.ascii = match_stl(text) != TextMatch::none;
    if (found.ascii) return found;
    throw Error(ErrorKind::bad_input, wrong + kind_of_text(text));
  }
  if (head.size() < header_bytes)
    throw Error(ErrorKind::bad_input,
                wrong + human_bytes(head.size()) + " are too short for an STL");
  // A random file would be read as a handful of wild faces. A damaged STL has a count that its size
  // nearly fits.
  if (found.stored && *found.stored == 0 && found.declared != 0) {
    throw Error(
        ErrorKind::bad_input,
        "'" + source.name() + "' ends inside its first face: it was cut short, or is no STL");
  }
  if (found.stored != found.declared && !looks_like_faces(head)) {
    throw Error(ErrorKind::bad_input, wrong +
                                          "as a binary STL it would have faces of wild numbers" +
                                          (found.stored ? ", and another size" : ""));
  }
  found.exact = !asked;
  if (found.exact && found.stored && !is_right_count(found.declared, *found.stored))
    refuse_count(source.name(), found.declared, *found.stored);
  return found;
}

InputFacts facts_of(const StlHead& head) {
  InputFacts facts;
  facts.format = head.ascii ? "STL ASCII" : "STL binary";
  if (!head.ascii) facts.faces = head.stored ? *head.stored : std::optional<std::uint64_t>{};
  return facts;
}

// What both forms share: positions are the faces' corners.
class StlReader : public MeshReader {
 public:
  StlReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory)
      : job_(job), source_(std::move(source)), memory_(memory) {}

  void begin_positions(PassCorners corners) override {
    corners_ = corners;
    begin_faces();
  }
  bool next_positions(RawBatch& batch) override { return next_faces(batch); }
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    decode_faces(batch, slice, [&](const FaceBatch& faces) { corners_as_positions(faces, sink); });
  }

  std::optional<std::array<double, 3>> first_finite_position() override {
    std::optional<std::array<double, 3>> found;
    FaceBatch slice;
    // Not restarted where the source cannot: what was peeked at is read again by begin_faces().
    begin_faces();
    if (!source_->seekable()) return peek_first_finite();
    for (RawBatch batch; !found && next_faces(batch);) {
      decode_faces(batch, slice, [&](const FaceBatch& faces) { look_for_finite(faces, found); });
    }
    return found;
  }

  [[nodiscard]] std::uint64_t bytes() const override {
    return std::max(bytes_seen_, source_->position());
  }
  [[nodiscard]] const std::string& name() const override { return source_->name(); }
  void check_whole() const override { source_->check_whole(); }

  bool next_part() override {
    if (colors_ && !colors_noted_) job_.note("not carried: colours of faces");
    colors_noted_ = colors_noted_ || colors_;
    return false;
  }

 protected:
  // On a pipe the batches looked at are kept and given out again.
  std::optional<std::array<double, 3>> peek_first_finite() {
    std::optional<std::array<double, 3>> found;
    FaceBatch slice;
    for (RawBatch batch; !found && read_faces(batch);) {
      decode_faces(batch, slice, [&](const FaceBatch& faces) { look_for_finite(faces, found); });
      const std::uint64_t seen = batch.first + batch.count;
      looked_at_.push_back(std::move(batch));
      // A pipe of nothing but bad faces must not pile up in memory.
      if (!found && looked_at_.size() >= 64) {
        throw Error(ErrorKind::bad_input, "'" + source_->name() + "': none of the first " +
                                              grouped(seen) +
                                              " faces has a finite corner; this is no mesh");
      }
    }
    return found;
  }

  static void look_for_finite(const FaceBatch& faces, std::optional<std::array<double, 3>>& found) {
    for (std::size_t i = 0; i < faces.count && !found; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::array<double, 3> xyz = faces.corner(corner, i);
        if (!found && std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]))
          found = xyz;
      }
    }
  }

  bool next_faces(RawBatch& batch) final {
    if (looked_at_.empty()) return read_faces(batch);
    batch = std::move(looked_at_.front());
    looked_at_.erase(looked_at_.begin());
    return true;
  }

  virtual bool read_faces(RawBatch& batch) = 0;

  Job& job_;
  std::unique_ptr<ByteSource> source_;
  ReaderMemory memory_;
  PassCorners corners_ = PassCorners::all;
  std::vector<RawBatch> looked_at_;
  std::uint64_t next_face_ = 0;
  std::uint64_t bytes_seen_ = 0;
  bool noted_ = false;  // the end was reached once and what is odd about it was said
  mutable std::atomic<bool> colors_ = false;  // faces have some

 private:
  bool colors_noted_ = false;
};

class BinaryStlReader final : public StlReader {
 public:
  BinaryStlReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                  const StlHead& head)
      : StlReader(job, std::move(source), memory), declared_(head.declared), exact_(head.exact) {
    facts_ = facts_of(head);
    if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
    const Block header = source_->take(header_bytes);
    const std::string_view text(reinterpret_cast<const char*>(header.bytes.data()),
                                header.bytes.size());
    colors_ = text.substr(0, 80).find("COLOR=") != std::string_view::npos;
  }

  void begin_faces() override {
    if (source_->position() != header_bytes && source_->seekable()) {
      source_->seek(header_bytes);
      next_face_ = 0;
    }
  }

  bool read_faces(RawBatch& batch) override {
    batch = {};
    batch.first = next_face_;
    batch.block = source_->take(memory_.batch_faces * face_bytes);
    batch.count = batch.block.bytes.size() / face_bytes;
    next_face_ += batch.count;
    const std::size_t rest = batch.block.bytes.size() - batch.count * face_bytes;
    if (batch.count == 0) {
      note_end(rest);
    } else {
      source_->give_back(rest);
    }
    return batch.count > 0;
  }

  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    const std::byte* record = batch.block.bytes.data() + 12;  // behind the face's normal
    slice.status.fill(FaceStatus::good);
    slice.all_good = true;
    slice.single = true;
    std::uint16_t attributes = 0;
    for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
      slice.count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
      slice.first = batch.first + from;
      for (std::size_t i = 0; i < slice.count; ++i, record += face_bytes) {
        std::array<float, 9> corners;
        std::memcpy(corners.data(), record, sizeof corners);
        for (std::size_t corner = 0; corner < 3; ++corner) {
          for (std::size_t axis = 0; axis < 3; ++axis)
            slice.single_position[corner][axis][i] = corners[3 * corner + axis];
        }
        std::uint16_t word = 0;
        std::memcpy(&word, record + sizeof corners, sizeof word);
        attributes |= word;
      }
      sink(slice);
    }
    batch.block.check_intact(source_->name());
    if ((attributes & valid_color) != 0) colors_ = true;
  }

  // Without the detour over faces: passes over positions are bound by nothing but this.
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    const std::byte* record = batch.block.bytes.data() + 12;
    const unsigned corners = corners_ == PassCorners::all ? 3 : 1;
    for (std::uint64_t from = 0; from < batch.count; from += FaceBatch::capacity) {
      const std::size_t count = std::min<std::uint64_t>(FaceBatch::capacity, batch.count - from);
      for (unsigned corner = 0; corner < corners; ++corner) {
        auto& [x, y, z] = slice.position[corner];
        for (std::size_t i = 0; i < count; ++i) {
          std::array<float, 3> xyz;
          std::memcpy(xyz.data(), record + i * face_bytes + corner * sizeof xyz, sizeof xyz);
          x[i] = xyz[0];
          y[i] = xyz[1];
          z[i] = xyz[2];
        }
        sink({{x.data(), y.data(), z.data()}, count, batch.first + from, corner});
      }
      record += count * face_bytes;
    }
    batch.block.check_intact(source_->name());
  }

 private:
  void note_end(std::size_t rest) {
    bytes_seen_ = source_->position();
    if (noted_) return;
    noted_ = true;
    if (!is_right_count(declared_, next_face_)) {
      if (exact_) refuse_count(source_->name(), declared_, next_face_);
      job_.note("the STL header says " + grouped(declared_) + " faces; there are " +
                grouped(next_face_));
    }
    if (rest > 0)
      job_.note("the last " + std::to_string(rest) + " bytes are no whole face and were left out");
  }

  static constexpr std::uint16_t valid_color = 0x8000;

  std::uint64_t declared_;
  bool exact_;
};

class AsciiStlReader final : public StlReader {
 public:
  AsciiStlReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                 const StlHead& head)
      : StlReader(job, std::move(source), memory) {
    facts_ = facts_of(head);
    if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
  }

  void begin_faces() override {
    if (!source_->seekable() && tokens_ != nullptr) return;
    if (source_->seekable()) source_->seek(0);
    skip_byte_order_mark(*source_);
    tokens_ = std::make_unique<TextTokens>(*source_);
    next_face_ = 0;
    place_ = Place::before;
    in_facet_ = in_loop_ = false;
  }

  bool read_faces(RawBatch& batch) override {
    batch = {};
    batch.first = next_face_;
    while (batch.count < memory_.batch_faces && read_face(batch)) {
    }
    next_face_ += batch.count;
    if (batch.count == 0) bytes_seen_ = source_->position();
    return batch.count > 0;
  }

  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    slice_corners(batch, slice, sink);
  }

 private:
  // What a word says. "end facet" is "endfacet".
  enum class Mark : std::uint8_t {
    other,
    comment,
    color,
    solid,
    facet,
    outer,
    vertex,
    end_solid,
    end_facet,
    end_loop,
    end_of_file
  };
  enum class Place : std::uint8_t { before, inside, behind };  // of a solid

  static Mark mark_of(std::string_view word) {
    switch (ascii_to_lower(word.front())) {
      case 'v':
        return is_word(word, "vertex") ? Mark::vertex : Mark::other;
      case 'f':
        return is_word(word, "facet") ? Mark::facet : Mark::other;
      case 'o':
        return is_word(word, "outer") ? Mark::outer : Mark::other;
      case 's':
        return is_word(word, "solid") ? Mark::solid : Mark::other;
      case 'c':
        return is_word(word, "color") || is_word(word, "colour") ? Mark::color : Mark::other;
      case '#':
      case ';':
        return Mark::comment;
      case '/':
        return word.starts_with("//") ? Mark::comment : Mark::other;
      case 'e':
        if (is_word(word.substr(0, 3), "end")) return mark_of_end(word.substr(3));
        return Mark::other;
      default:
        return Mark::other;
    }
  }

  static Mark mark_of_end(std::string_view what) {
    if (is_word(what, "facet")) return Mark::end_facet;
    if (is_word(what, "loop")) return Mark::end_loop;
    return is_word(what, "solid") ? Mark::end_solid : Mark::other;
  }

  Mark next_mark() {
    word_ = tokens_->next();
    if (word_.empty()) return Mark::end_of_file;
    if (!is_word(word_, "end")) return mark_of(word_);
    word_ = tokens_->next_in_line();
    return mark_of_end(word_);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, "'" + source_->name() + "', line " +
                                          grouped(tokens_->line()) + ", face " +
                                          grouped(next_face_ + found_) + ": " + what);
  }

  // The name of a solid may hold any words and ends with its line, or, where the whole file is one
  // line, before "outer loop vertex". Whether that was there.
  bool pass_over_name() {
    std::size_t found = 0;
    constexpr std::array<std::string_view, 3> begin{"outer", "loop", "vertex"};
    for (std::string_view word = tokens_->next_in_line(); !word.empty();
         word = tokens_->next_in_line()) {
      found = is_word(word, begin.at(found)) ? found + 1 : is_word(word, begin[0]) ? 1 : 0;
      if (found == begin.size()) return true;
    }
    return false;
  }

  void pass_over_color() {
    for (int component = 0; component < 3; ++component) tokens_->next_in_line();
    colors_ = true;
  }

  // Goes on to the next face: to its "facet", or where that is missing to its "outer" or its first
  // "vertex", which is returned. At the end of the file, that.
  Mark find_face() {
    for (;;) {
      const Mark mark = next_mark();
      if (mark == Mark::end_of_file) {
        if (in_facet_) fail("the file ends inside a face: it was cut short");
        note_end();
        return mark;
      }
      if (mark == Mark::solid || mark == Mark::end_solid) {
        place_ = mark == Mark::solid ? Place::inside : Place::behind;
        in_facet_ = false;
        if (!pass_over_name()) continue;
        place_ = Place::inside;
        in_loop_ = true;
        return Mark::vertex;
      }
      if (mark == Mark::comment || place_ == Place::behind) {
        tokens_->skip_line();
        continue;
      }
      switch (mark) {
        case Mark::facet:
          if (in_facet_) fail("a face begins inside another; 'endfacet' is missing");
          [[fallthrough]];
        case Mark::outer:
        case Mark::vertex:
          in_facet_ = in_facet_ || mark == Mark::facet;
          in_loop_ = mark == Mark::outer;
          place_ = Place::inside;
          return mark;
        case Mark::color:
          pass_over_color();
          break;
        case Mark::end_facet:
          in_facet_ = false;
          break;
        case Mark::end_loop:
          break;
        default:
          if (place_ == Place::before) {
            tokens_->skip_line();
          } else if (!in_facet_) {
            fail("expected 'facet', not '" + std::string(word_.substr(0, 40)) + "'");
          }
      }
    }
  }

  // A face ends with its loop, or its facet, or, where there are neither, with its third corner.
  bool read_face(RawBatch& batch) {
    found_ = batch.count;
    Mark mark = find_face();
    if (mark == Mark::end_of_file) return false;
    if (mark != Mark::vertex) mark = next_mark();
    corners_.clear();
    for (; mark != Mark::end_loop && mark != Mark::end_facet; mark = next_mark()) {
      if (mark == Mark::end_of_file) fail("the file ends inside a face: it was cut short");
      if (mark == Mark::facet) fail("a face begins inside another; 'endfacet' is missing");
      if (mark == Mark::comment) tokens_->skip_line();
      if (mark == Mark::color) pass_over_color();
      if (mark == Mark::outer) in_loop_ = true;
      if (mark != Mark::vertex) continue;  // the normal, "loop"
      if (corners_.size() == most_corners) fail("it has more than 512 corners; this is no STL");
      corners_.push_back(read_position());
      if (corners_.size() == 3 && !in_loop_ && !in_facet_) break;
    }
    in_loop_ = false;
    if (mark == Mark::end_facet) in_facet_ = false;
    add_polygon(batch);
    return true;
  }

  Point read_position() {
    Point xyz{};
    for (double& value : xyz) {
      const std::string_view number = tokens_->next();
      const std::optional<double> parsed = parse_real(number);
      if (!parsed) fail(not_a_number(number));
      // What binary STL would hold, so that both forms of a file are the same mesh.
      value = static_cast<float>(*parsed);
    }
    return xyz;
  }

  // A face should have three corners.
  void add_polygon(RawBatch& batch) {
    if (corners_.size() < 3) {
      // Nowhere: a corner that is not there must not widen the box.
      constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
      const Point none{nowhere, nowhere, nowhere};
      return add_face(batch, none, none, none, FaceStatus::degenerate);
    }
    if (corners_.size() > 3) {
      const auto& cut = cutter_.cut(corners_);
      for (const auto& [a, b, c] : cut)
        add_face(batch, corners_[a], corners_[b], corners_[c], FaceStatus::good);
      if (!cut.empty()) return;
    }
    for (std::size_t i = 2; i < corners_.size(); ++i)
      add_face(batch, corners_[0], corners_[i - 1], corners_[i], FaceStatus::good);
  }

  static void add_face(RawBatch& batch, const Point& a, const Point& b, const Point& c,
                       FaceStatus status) {
    for (const Point& corner : {a, b, c})
      batch.corners.insert(batch.corners.end(), corner.begin(), corner.end());
    batch.status.push_back(status);
    ++batch.count;
  }

  void note_end() {
    if (place_ == Place::inside && !noted_)
      job_.note("the file ends without 'endsolid'; it may have been cut short");
    noted_ = true;
  }

  static constexpr std::size_t most_corners = 512;

  std::unique_ptr<TextTokens> tokens_;
  std::vector<Point> corners_;  // of the face at work
  PolygonCutter cutter_;
  std::string_view word_;  // the last one
  std::uint64_t found_ = 0;
  Place place_ = Place::before;
  bool in_facet_ = false;
  bool in_loop_ = false;
};

}  // namespace

TextMatch match_stl(std::string_view head) {
  TextMatch match = TextMatch::first;
  TextLines each(head);
  for (std::string_view line; each.next(line);) {
    LineWords words(line);
    const std::string_view word = words.next();
    if (word.empty() || word.starts_with("//") || word.front() == ';') continue;
    if ((is_word(word, "facet") && is_word(words.next(), "normal")) ||
        (is_word(word, "outer") && is_word(words.next(), "loop"))) {
      return match;
    }
    // A long name can fill what was looked at.
    if (is_word(word, "solid") &&
        (contains_word(head, "facet") || contains_word(head, "vertex") ||
         contains_word(head, "endsolid") || contains_word(head, "end solid") ||
         head.size() < header_bytes || head.size() + 3 >= text_head_bytes)) {
      return match;
    }
    match = TextMatch::later;
  }
  return TextMatch::none;
}

bool has_size_of_binary_stl(ByteSource& source) {
  if (!source.size() || *source.size() < header_bytes) return false;
  const Block block = source.peek(header_bytes);
  std::uint32_t declared = 0;
  std::memcpy(&declared, block.bytes.data() + 80, sizeof declared);
  return *source.size() == header_bytes + face_bytes * std::uint64_t{declared};
}

std::unique_ptr<MeshReader> open_stl(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory, bool asked) {
  const StlHead head = look_at_head(*source, asked);
  if (head.ascii) return std::make_unique<AsciiStlReader>(job, std::move(source), memory, head);
  return std::make_unique<BinaryStlReader>(job, std::move(source), memory, head);
}

InputProbe probe_stl(ByteSource& source, bool asked) {
  InputProbe probe;
  probe.facts = facts_of(look_at_head(source, asked));
  return probe;
}

}  // namespace winnow
