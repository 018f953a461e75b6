// STL: binary (80 bytes of anything, a 32-bit count, 50 bytes a face) and ASCII.
#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/formats.hpp"
#include "read/slices.hpp"
#include "read/text_tokens.hpp"

#include <algorithm>
#include <array>
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
  std::uint32_t declared = 0;           // binary only
  std::optional<std::uint64_t> stored;  // whole faces by the file's size, where that is known
};

bool contains_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) { return small_letter(a) == b; };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

// Any binary file could be an STL. Whether half of the faces that are looked at are of numbers that a model
// may have.
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

// What there is to decide by: whether it begins with "solid", whether it reads like text, whether the count
// fits the size. Many binary files begin with "solid" all the same.
StlHead look_at_head(ByteSource& source) {
  const Block block = source.peek(1024);
  const std::string_view head(reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size());
  if (head.empty()) throw Error(ErrorKind::bad_input, "'" + source.name() + "' is empty");
  StlHead found;
  if (head.size() >= header_bytes) std::memcpy(&found.declared, head.data() + 80, sizeof found.declared);
  if (source.size() && *source.size() >= header_bytes) {
    found.stored = (*source.size() - header_bytes) / face_bytes;
    if (*source.size() == header_bytes + face_bytes * std::uint64_t{found.declared}) return found;
  }
  const bool solid = contains_word(head.substr(0, head.find_first_not_of(" \t\r\n") + 5), "solid");
  // A long name can fill what was looked at; text all through is then enough.
  const bool facets = contains_word(head, "facet") || contains_word(head, "endsolid") || head.size() == 1024;
  if (solid && is_text(head) && (facets || head.size() < header_bytes)) {
    found.ascii = true;
    return found;
  }
  const std::string wrong = "'" + source.name() + "' is no mesh in a format that winnow reads: ";
  if (is_text(head)) throw Error(ErrorKind::bad_input, wrong + "it is some other text");
  if (head.size() < header_bytes)
    throw Error(ErrorKind::bad_input, wrong + human_bytes(head.size()) + " are too short for an STL");
  // A random file would be read as a handful of wild faces. A damaged STL has a count that its size nearly
  // fits.
  if (found.stored && *found.stored == 0 && found.declared != 0) {
    throw Error(ErrorKind::bad_input,
                "'" + source.name() + "' ends inside its first face: it was cut short, or is no STL");
  }
  if (found.stored != found.declared && !looks_like_faces(head)) {
    throw Error(ErrorKind::bad_input, wrong + "as a binary STL it would have faces of wild numbers" +
                                          (found.stored ? ", and another size" : ""));
  }
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
  void decode_positions(const RawBatch& batch, FaceBatch& slice, const PositionSink& sink) const override {
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

  [[nodiscard]] std::uint64_t bytes() const override { return std::max(bytes_seen_, source_->position()); }
  [[nodiscard]] const std::string& name() const override { return source_->name(); }
  void check_whole() const override { source_->check_whole(); }

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
        throw Error(ErrorKind::bad_input, "'" + source_->name() + "': none of the first " + grouped(seen) +
                                              " faces has a finite corner; this is no mesh");
      }
    }
    return found;
  }

  static void look_for_finite(const FaceBatch& faces, std::optional<std::array<double, 3>>& found) {
    for (std::size_t i = 0; i < faces.count && !found; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::array<double, 3> xyz = faces.corner(corner, i);
        if (!found && std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2])) found = xyz;
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
};

class BinaryStlReader final : public StlReader {
 public:
  BinaryStlReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                  const StlHead& head)
      : StlReader(job, std::move(source), memory), declared_(head.declared) {
    facts_ = facts_of(head);
    if (!source_->compression().empty()) facts_.format += ", " + source_->compression();
    source_->take(header_bytes);
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
      }
      sink(slice);
    }
    batch.block.check_intact(source_->name());
  }

  // Without the detour over faces: passes over positions are bound by nothing but this.
  void decode_positions(const RawBatch& batch, FaceBatch& slice, const PositionSink& sink) const override {
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
    if (next_face_ != declared_ && !(declared_ == UINT32_MAX && next_face_ > declared_)) {
      job_.note("the STL header says " + grouped(declared_) + " faces; there are " + grouped(next_face_));
    }
    if (rest > 0)
      job_.note("the last " + std::to_string(rest) + " bytes are no whole face and were left out");
  }

  std::uint64_t declared_;
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
    if (!source_->seekable()) {
      if (tokens_ == nullptr) tokens_ = std::make_unique<TextTokens>(*source_);
      return;
    }
    source_->seek(0);
    tokens_ = std::make_unique<TextTokens>(*source_);
    next_face_ = 0;
  }

  bool read_faces(RawBatch& batch) override {
    batch = {};
    batch.first = next_face_;
    while (batch.count < memory_.batch_faces && read_facet(batch)) {
    }
    next_face_ += batch.count;
    if (batch.count == 0) bytes_seen_ = source_->position();
    return batch.count > 0;
  }

  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    slice_corners(batch, slice, sink);
  }

 private:
  static bool same(std::string_view word, std::string_view keyword) {
    return word.size() == keyword.size() && contains_word(word, keyword);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, "'" + source_->name() + "', line " + grouped(tokens_->line()) +
                                          ", face " + grouped(next_face_ + found_) + ": " + what);
  }

  // Everything between one "facet" and its "endfacet"; false at the end of the file. Names of solids may
  // hold any words, so lines that begin or end a solid are skipped whole.
  bool read_facet(RawBatch& batch) {
    found_ = batch.count;
    for (;;) {
      const std::string_view word = tokens_->next();
      if (word.empty()) {
        note_end();
        return false;
      }
      if (same(word, "solid") || same(word, "endsolid")) {
        in_solid_ = same(word, "solid");
        tokens_->skip_line();
      } else if (same(word, "facet")) {
        break;
      } else {
        fail("expected 'facet', not '" + std::string(word.substr(0, 40)) + "'");
      }
    }
    std::array<double, 9> corners{};
    std::size_t vertices = 0;
    for (;;) {
      const std::string_view word = tokens_->next();
      if (word.empty()) fail("the file ends inside a face: it was cut short");
      if (same(word, "endfacet")) break;
      if (same(word, "facet")) fail("a face begins inside another; 'endfacet' is missing");
      if (!same(word, "vertex")) continue;  // the normal, "outer loop", "endloop"
      std::array<double, 3> xyz{};
      for (double& value : xyz) {
        const std::string_view number = tokens_->next();
        const std::optional<double> parsed = parse_real(number);
        if (!parsed) fail("'" + std::string(number.substr(0, 40)) + "' is not a number");
        // What binary STL would hold, so that both forms of a file are the same mesh.
        value = static_cast<float>(*parsed);
      }
      if (vertices == most_corners) fail("it has more than 512 corners; this is no STL");
      add_vertex(batch, corners, vertices++, xyz);
    }
    if (vertices < 3) {
      // Nowhere: a corner that is not there must not widen the box.
      corners.fill(std::numeric_limits<double>::quiet_NaN());
      add_face(batch, corners, FaceStatus::degenerate);
    }
    return true;
  }

  // A face should have three; of more, a fan is made.
  void add_vertex(RawBatch& batch, std::array<double, 9>& corners, std::size_t number,
                  const std::array<double, 3>& xyz) const {
    if (number >= 3) std::copy_n(corners.begin() + 6, 3, corners.begin() + 3);
    std::copy_n(xyz.begin(), 3,
                corners.begin() + static_cast<std::ptrdiff_t>(3 * std::min<std::size_t>(number, 2)));
    if (number >= 2) add_face(batch, corners, FaceStatus::good);
  }

  static void add_face(RawBatch& batch, const std::array<double, 9>& corners, FaceStatus status) {
    batch.corners.insert(batch.corners.end(), corners.begin(), corners.end());
    batch.status.push_back(status);
    ++batch.count;
  }

  void note_end() {
    if (in_solid_ && !noted_) job_.note("the file ends without 'endsolid'; it may have been cut short");
    noted_ = true;
  }

  static constexpr std::size_t most_corners = 512;

  std::unique_ptr<TextTokens> tokens_;
  std::uint64_t found_ = 0;
  bool in_solid_ = false;
};

}  // namespace

std::unique_ptr<MeshReader> open_stl(Job& job, std::unique_ptr<ByteSource> source,
                                     const ReaderMemory& memory) {
  const StlHead head = look_at_head(*source);
  if (head.ascii) return std::make_unique<AsciiStlReader>(job, std::move(source), memory, head);
  return std::make_unique<BinaryStlReader>(job, std::move(source), memory, head);
}

InputOutlook look_at_stl(ByteSource& source) {
  InputOutlook outlook;
  outlook.facts = facts_of(look_at_head(source));
  return outlook;
}

}  // namespace winnow
