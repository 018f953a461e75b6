#include "read/joined_reader.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace winnow {

namespace {

// The sum of what is known; unknown where any is.
void add(std::optional<std::uint64_t>& sum, const std::optional<std::uint64_t>& count) {
  if (sum && count) {
    *sum += *count;
  } else {
    sum.reset();
  }
}

// Has nothing to carry, and keeps others from nothing.
bool is_bare(const InputProbe& probe) {
  return probe.facts.vertices == std::uint64_t{0};
}

std::string joint_name(const std::vector<std::string>& names) {
  return names.front() + " and " + grouped(names.size() - 1) + " more";
}

// Each once, in the order in which they come.
std::string joined_formats(const std::vector<std::string>& formats) {
  std::string text;
  for (auto one = formats.begin(); one != formats.end(); ++one) {
    if (std::find(formats.begin(), one, *one) == one) text += (text.empty() ? "" : " and ") + *one;
  }
  return text;
}

// As its type can have it.
double color_of_light(NumberType type, double stored) {
  const Attribute light{{}, type, AttributeKind::light};
  const double color = stored_of_mean(light, mean_of_stored(light, stored));
  return is_integer(type) ? std::nearbyint(color) : color;
}

class JoinedReader final : public MeshReader {
 public:
  JoinedReader(Job& job, const std::vector<std::string>& names, Format format,
               const ReaderMemory& memory, const AttributeRequest& wish)
      : job_(job),
        names_(names),
        format_(format),
        memory_(memory),
        name_(joint_name(names)),
        bytes_(names.size()) {
    std::vector<std::string> formats;
    std::vector<AvailableAttributes> offers;
    facts_.faces = facts_.vertices = 0;
    facts_.normals = true;
    for (std::size_t i = 0; i < names.size(); ++i) {
      open(i);
      const InputFacts& facts = reader_->facts();
      formats.push_back(facts.format);
      add(facts_.faces, facts.faces);
      add(facts_.vertices, facts.vertices);
      facts_.polygons |= facts.polygons;
      facts_.mixed_positions |= i > 0 && facts.double_positions != facts_.double_positions;
      facts_.double_positions |= facts.double_positions;
      facts_.normals &= facts.normals;
      if (!bare_) offers.push_back(facts.offer);
    }
    facts_.offer = common_offer(offers);
    facts_.choice = choose_attributes(wish, facts_.offer, name_);
    carried_.names.emplace();
    carried_.no_data = wish.no_data;
    for (const Attribute& attribute : facts_.choice.carried)
      carried_.names->push_back(attribute.name);
    facts_.format = joined_formats(formats);
  }

  void begin_positions(PassCorners corners) override {
    corners_ = corners;
    positions_ = true;
    begin(0);
  }
  bool next_positions(RawBatch& batch) override {
    return seen(batch, reader_->next_positions(batch));
  }
  void decode_positions(const RawBatch& batch, FaceBatch& slice,
                        const PositionSink& sink) const override {
    reader_->decode_positions(batch, slice, [&](const PositionView& view) {
      PositionView numbered = view;
      numbered.first += before_;
      numbered.first_vertex = vertices_before_ - (view.only_faces ? 3 : 1) * before_;
      sink(numbered);
    });
  }

  void begin_faces() override {
    positions_ = false;
    begin(0);
  }
  bool next_faces(RawBatch& batch) override { return seen(batch, reader_->next_faces(batch)); }
  void decode_faces(const RawBatch& batch, FaceBatch& slice, const FaceSink& sink) const override {
    std::vector<double> attributes(facts_.choice.carried.size() * block);
    std::array<std::uint32_t, FaceBatch::capacity> numbers{};
    reader_->decode_faces(batch, slice, [&](const FaceBatch& /*slice*/) {
      slice.first += before_;
      // Where there are only faces, their vertices are counted by `first`.
      slice.first_vertex = vertices_before_ - (slice.index[0] == nullptr ? 3 * before_ : 0);
      if (slice.numbers != nullptr) {
        std::transform(
            slice.numbers, slice.numbers + slice.count, numbers.begin(),
            [&](std::uint32_t number) { return number + static_cast<std::uint32_t>(before_); });
        slice.numbers = numbers.data();
      }
      for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto from =
            slice.attributes.begin() + static_cast<std::ptrdiff_t>(place_[i].number * block);
        const auto to = attributes.begin() + static_cast<std::ptrdiff_t>(i * block);
        std::copy_n(from, block, to);
        if (!place_[i].light) continue;
        const NumberType type = facts_.choice.carried[i].type;
        for (std::size_t corner = 0; corner < 3; ++corner) {
          const auto first = to + static_cast<std::ptrdiff_t>(corner * FaceBatch::capacity);
          std::transform(first, first + static_cast<std::ptrdiff_t>(slice.count), first,
                         [&](double stored) { return color_of_light(type, stored); });
        }
      }
      slice.attributes.swap(attributes);
      sink(slice);
      slice.attributes.swap(attributes);
    });
  }

  bool next_part() override {
    if (reader_->next_part()) return true;
    if (current_ + 1 == names_.size()) return false;
    const std::uint64_t before = before_ + seen_;
    const std::uint64_t vertices = vertices_before_ + reader_->facts().vertices.value_or(3 * seen_);
    begin(current_ + 1);
    before_ = before;
    vertices_before_ = vertices;
    return true;
  }

  std::optional<std::array<double, 3>> first_finite_position() override {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      open(i);
      if (const auto found = reader_->first_finite_position()) return found;
    }
    return {};
  }

  std::vector<AttributeRange> attribute_ranges() override {
    std::vector<AttributeRange> ranges(facts_.choice.carried.size());
    for (std::size_t part = 0; part < names_.size() && !ranges.empty(); ++part) {
      open(part);
      const std::vector<AttributeRange> here = reader_->attribute_ranges();
      for (std::size_t i = 0; i < place_.size(); ++i) {
        const AttributeRange& range = here[place_[i].number];
        const double largest = place_[i].light
                                   ? color_of_light(facts_.choice.carried[i].type, range.largest)
                                   : range.largest;
        ranges[i].largest = std::max(ranges[i].largest, largest);
        ranges[i].without += range.without;
      }
    }
    return ranges;
  }

  void release_memory() override { reader_->release_memory(); }
  void check_whole() const override { reader_->check_whole(); }
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::uint64_t bytes() const override {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bytes_.size(); ++i)
      sum += i == current_ ? std::max(bytes_[i], reader_->bytes()) : bytes_[i];
    return sum;
  }

 private:
  void open(std::size_t part) {
    if (reader_ != nullptr) bytes_[current_] = std::max(bytes_[current_], reader_->bytes());
    reader_.reset();
    current_ = part;
    std::unique_ptr<ByteSource> source = open_source(job_, names_[part]);
    const std::optional<FileVersion> version = source->version();
    if (versions_.size() <= part) {
      versions_.push_back(version);
    } else if (version != versions_[part]) {
      changed(names_[part]);
    }
    bare_ = is_bare(probe_input(job_, *source, format_, Access::once));
    reader_ = open_reader(job_, std::move(source), format_, Access::once, memory_,
                          bare_ ? AttributeRequest{} : carried_);
    place_.clear();
    if (bare_ || carried_.none()) return;
    // Each file has them in an order of its own.
    const std::vector<Attribute>& here = reader_->facts().choice.carried;
    for (const Attribute& attribute : facts_.choice.carried) {
      const auto found = std::find_if(here.begin(), here.end(), [&](const Attribute& one) {
        return one.name == attribute.name && one.type == attribute.type;
      });
      if (found == here.end()) {
        throw Error(ErrorKind::bad_input, "'" + names_[part] + "' lacks '" + attribute.name +
                                              "' by now: it was changed meanwhile");
      }
      place_.push_back(
          {static_cast<std::size_t>(found - here.begin()),
           found->kind == AttributeKind::light && attribute.kind != AttributeKind::light});
    }
  }

  void begin(std::size_t part) {
    open(part);
    before_ = seen_ = vertices_before_ = 0;
    if (positions_) {
      reader_->begin_positions(corners_);
    } else {
      reader_->begin_faces();
    }
  }

  bool seen(const RawBatch& batch, bool more) {
    if (more) seen_ = batch.first + batch.count;
    return more;
  }

  static constexpr std::size_t block =
      3 * FaceBatch::capacity;  // numbers of one attribute in a batch

  Job& job_;
  std::vector<std::string> names_;
  Format format_;
  ReaderMemory memory_;
  std::string name_;
  std::vector<std::uint64_t> bytes_;                  // of each file, as far as it was read
  std::vector<std::optional<FileVersion>> versions_;  // of each file, when it was first opened
  AttributeRequest carried_;                          // what is asked of each file
  // Of each attribute its number among those of the file at work, and whether it is of light there
  // and of colours here.
  struct Place {
    std::size_t number;
    bool light;
  };
  std::vector<Place> place_;
  std::unique_ptr<MeshReader> reader_;
  std::size_t current_ = 0;
  bool bare_ = false;                  // this one
  std::uint64_t before_ = 0;           // faces or positions of the files before
  std::uint64_t vertices_before_ = 0;  // of the files before
  std::uint64_t seen_ = 0;             // of this one
  bool positions_ = false;
  PassCorners corners_ = PassCorners::all;
};

void check_regular(const std::string& name) {
  std::error_code ignored;
  const auto status = std::filesystem::status(name, ignored);
  if (name == "-" ||
      (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))) {
    throw Error(ErrorKind::usage,
                "several inputs are read more than once, so each must be a file, which '" + name +
                    "' is not; join them first, or name it alone");
  }
}

}  // namespace

std::unique_ptr<MeshReader> join_files(Job& job, const std::vector<std::string>& names,
                                       Format format, const ReaderMemory& memory,
                                       const AttributeRequest& wish) {
  return std::make_unique<JoinedReader>(job, names, format, memory, wish);
}

InputProbe look_at_files(Job& job, const std::vector<std::string>& names, Format format,
                         const AttributeRequest& wish) {
  InputProbe probe;
  std::vector<AvailableAttributes> offers;
  probe.facts.faces = probe.facts.vertices = 0;
  std::vector<std::string> formats;
  probe.bytes = 0;
  for (const std::string& name : names) {
    const std::unique_ptr<ByteSource> source = open_source(job, name);
    const InputProbe one = probe_input(job, *source, format, Access::once);
    add(probe.facts.faces, one.facts.faces);
    add(probe.facts.vertices, one.facts.vertices);
    formats.push_back(one.facts.format);
    add(probe.bytes, one.bytes);
    probe.facts.polygons |= one.facts.polygons;
    probe.facts.double_positions |= one.facts.double_positions;
    probe.vertices_buffered |= one.vertices_buffered;
    probe.vertex_bytes = std::max(probe.vertex_bytes, one.vertex_bytes);
    probe.faces_buffered |= one.faces_buffered;
    probe.taken_in |= one.taken_in;
    if (!is_bare(one)) offers.push_back(one.facts.offer);
  }
  probe.facts.format = joined_formats(formats);
  probe.facts.offer = common_offer(offers);
  probe.facts.choice = choose_attributes(wish, probe.facts.offer, joint_name(names));
  return probe;
}

std::uint64_t memory_to_open(Job& job, const std::vector<std::string>& names) {
  std::uint64_t most = 0;
  for (const std::string& name : names) {
    check_regular(name);
    const std::unique_ptr<ByteSource> source = open_source(job, name);
    source->peek(1);
    most = std::max(most, job.budget.used());
  }
  return most;
}

}  // namespace winnow
