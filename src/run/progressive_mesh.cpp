// A progressive file that is open, and what its header says.
#include <winnow/error.hpp>
#include <winnow/progressive.hpp>

#include "base/number_type.hpp"
#include "base/text.hpp"
#include "io/job.hpp"
#include "progressive/split_player.hpp"
#include "run/attributes.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <span>
#include <utility>

namespace winnow {

namespace {

std::unique_ptr<ByteSource> seekable_source(Job& job, const std::string& input) {
  std::unique_ptr<ByteSource> source = open_source(job, input);
  return source->seekable() ? std::move(source) : copy_to_scratch(job, std::move(source));
}

template <typename Number>
void put_positions(const SplitPlayer& player, std::vector<Number>& out) {
  const SplitMesh& mesh = player.mesh();
  out.reserve(3 * std::size_t{mesh.vertices()});
  for (std::uint32_t v = 0; v < mesh.vertices(); ++v) {
    for (const double x : player.words().position(mesh.words(v)))
      out.push_back(static_cast<Number>(x));
  }
}

std::string positions_of(const PositionForm& form) {
  if (form.bits > 0) return std::to_string(form.bits) + " bits";
  return form.doubles ? "double" : "float";
}

}  // namespace

struct ProgressiveMesh::Implementation {
  Job job;
  SplitPlayer player;

  Implementation(Context& context, const std::string& input)
      : job(context), player(job, seekable_source(job, input), true) {}
};

ProgressiveMesh::ProgressiveMesh(Context& context, const std::string& input)
    : implementation_(std::make_unique<Implementation>(context, input)) {}
ProgressiveMesh::~ProgressiveMesh() = default;
ProgressiveMesh::ProgressiveMesh(ProgressiveMesh&&) noexcept = default;
ProgressiveMesh& ProgressiveMesh::operator=(ProgressiveMesh&&) noexcept = default;

std::uint64_t ProgressiveMesh::base_face_count() const {
  return implementation_->player.header().base().faces;
}
std::uint64_t ProgressiveMesh::full_face_count() const {
  return implementation_->player.header().all().faces;
}
std::uint64_t ProgressiveMesh::face_count() const {
  return implementation_->player.mesh().faces();
}
std::uint64_t ProgressiveMesh::vertex_count() const {
  return implementation_->player.mesh().vertices();
}

void ProgressiveMesh::go_to(std::uint64_t faces) {
  SplitPlayer& player = implementation_->player;
  if (faces < base_face_count())
    throw Error(ErrorKind::usage, "the coarsest mesh has " + grouped(base_face_count()) + " faces");
  player.go_to(faces);
  if (player.cut_short() && face_count() < std::min(faces, full_face_count()))
    throw Error(ErrorKind::bad_input,
                "the file is cut short: it ends after " + grouped(face_count()) + " faces");
}

bool ProgressiveMesh::step_forward() {
  return implementation_->player.forward();
}
bool ProgressiveMesh::step_back() {
  return implementation_->player.backward();
}

Mesh ProgressiveMesh::mesh() const {
  const SplitPlayer& player = implementation_->player;
  const SplitMesh& shown = player.mesh();
  Mesh out;
  if (player.header().form.doubles) {
    put_positions(player, out.positions.emplace<std::vector<double>>());
  } else {
    put_positions(player, out.positions.emplace<std::vector<float>>());
  }
  out.faces.reserve(3 * std::size_t{shown.faces()});
  for (std::uint32_t f = 0; f < shown.faces(); ++f)
    out.faces.insert(out.faces.end(), shown.face(f).begin(), shown.face(f).end());
  const std::vector<Attribute>& attributes = player.header().attributes;
  std::vector<double> means(attributes.size());
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    Mesh::Attribute& attribute = out.attributes.emplace_back();
    attribute.name = attributes[i].name;
    with_type(attributes[i].type, [&]<typename Number>(Number) {
      auto& values = attribute.values.emplace<std::vector<Number>>(shown.vertices());
      const std::span<std::byte> bytes = std::as_writable_bytes(std::span(values));
      for (std::uint32_t v = 0; v < shown.vertices(); ++v) {
        player.words().means(shown.words(v), means);
        store_rounded(stored_of_mean(attributes[i], means[i]), attributes[i].type,
                      bytes.data() + v * sizeof(Number));
      }
    });
  }
  return out;
}

bool is_progressive(const std::string& input) {
  if (input == "-") return false;
  std::ifstream file(input, std::ios::binary);
  std::array<char, progressive_magic.size()> head{};
  file.read(head.data(), head.size());
  return file &&
         std::equal(head.begin(), head.end(), progressive_magic.begin(),
                    [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

ProgressiveInfo progressive_info(Context& context, const std::string& input) {
  Job job(context);
  const std::unique_ptr<ByteSource> source = open_source(job, input);
  const ProgressiveHeader header = read_header(job, *source);
  ProgressiveInfo info;
  const ProgressiveHeader::Counts all = header.all(), base = header.base();
  info.name = input;
  info.format = "progressive mesh, version " + std::to_string(progressive_version);
  info.bytes = all.bytes;
  info.faces = all.faces;
  info.vertices = all.vertices;
  info.base_faces = base.faces;
  info.base_vertices = base.vertices;
  info.chunks = header.chunks.size();
  info.cost = header.cost;
  info.positions = positions_of(header.form);
  info.box_min = header.box.low;
  info.box_max = header.box.high;
  AttributeSelection choice;
  choice.carried = header.attributes;
  info.attributes = descriptions(choice);
  const auto add = [&](std::uint64_t faces) {
    const std::size_t chunks = header.chunks_for(faces);
    ProgressiveInfo::Prefix& prefix = info.prefixes.emplace_back();
    prefix.faces = faces;
    prefix.bytes = header.counts(chunks).bytes;
    if (std::isfinite(header.error_of(chunks))) prefix.error = header.error_of(chunks);
  };
  for (std::uint64_t faces = base.faces; faces < all.faces && faces > 0; faces *= 10) add(faces);
  add(all.faces);
  if (source->size() && *source->size() < all.bytes) {
    std::size_t whole = header.base_chunks;
    while (whole < header.chunks.size() && header.counts(whole + 1).bytes <= *source->size())
      ++whole;
    info.notes.push_back("the file is cut short: " + grouped(*source->size()) + " of " +
                         grouped(all.bytes) + " bytes are there" +
                         (header.base().bytes <= *source->size()
                              ? ", enough for " + grouped(header.counts(whole).faces) + " faces"
                              : ""));
  }
  return info;
}

}  // namespace winnow
