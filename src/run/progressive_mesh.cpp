// A progressive file that is open.
#include <winnow/error.hpp>
#include <winnow/progressive.hpp>

#include "base/number_type.hpp"
#include "base/text.hpp"
#include "io/job.hpp"
#include "progressive/split_player.hpp"

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

}  // namespace winnow
