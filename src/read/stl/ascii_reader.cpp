// STL as text, in every spelling that is common.
#include "base/vector.hpp"
#include "read/polygons/polygon_cutter.hpp"
#include "read/stl/reader.hpp"
#include "read/text/lines.hpp"
#include "read/text/tokens.hpp"

#include <limits>
#include <string_view>

namespace winnow {

namespace {

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
        return is_stl_word(word, "vertex") ? Mark::vertex : Mark::other;
      case 'f':
        return is_stl_word(word, "facet") ? Mark::facet : Mark::other;
      case 'o':
        return is_stl_word(word, "outer") ? Mark::outer : Mark::other;
      case 's':
        return is_stl_word(word, "solid") ? Mark::solid : Mark::other;
      case 'c':
        return is_stl_word(word, "color") || is_stl_word(word, "colour") ? Mark::color
                                                                         : Mark::other;
      case '#':
      case ';':
        return Mark::comment;
      case '/':
        return word.starts_with("//") ? Mark::comment : Mark::other;
      case 'e':
        if (is_stl_word(word.substr(0, 3), "end")) return mark_of_end(word.substr(3));
        return Mark::other;
      default:
        return Mark::other;
    }
  }

  static Mark mark_of_end(std::string_view what) {
    if (is_stl_word(what, "facet")) return Mark::end_facet;
    if (is_stl_word(what, "loop")) return Mark::end_loop;
    return is_stl_word(what, "solid") ? Mark::end_solid : Mark::other;
  }

  Mark next_mark() {
    word_ = tokens_->next();
    if (word_.empty()) return Mark::end_of_file;
    if (!is_stl_word(word_, "end")) return mark_of(word_);
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
      found = is_stl_word(word, begin.at(found)) ? found + 1 : is_stl_word(word, begin[0]) ? 1 : 0;
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

std::unique_ptr<MeshReader> make_ascii_stl_reader(Job& job, std::unique_ptr<ByteSource> source,
                                                  const ReaderMemory& memory, const StlHead& head) {
  return std::make_unique<AsciiStlReader>(job, std::move(source), memory, head);
}

}  // namespace winnow
