// Readers, by all their ways: as a file and as a pipe, in large batches and small ones. All say the
// same.
#include "base/hash.hpp"
#include "fuzz/job.hpp"
#include "fuzz/targets.hpp"
#include "read/mesh_reader.hpp"
#include "support/sources.hpp"

#include <bit>
#include <optional>

namespace winnow::fuzz {

namespace {

// More than so many triangles can come of few bytes only by run-length tricks that no format has.
constexpr std::uint64_t most_faces = std::uint64_t{1} << 22;

struct Faces {
  std::uint64_t count = 0, sum = 0;
  bool operator==(const Faces&) const = default;
};

Faces faces_of(MeshReader& reader) {
  Faces faces;
  reader.begin_faces();
  FaceBatch slice;
  for (RawBatch batch; reader.next_faces(batch); batch = {}) {
    reader.decode_faces(batch, slice, [&](const FaceBatch& decoded) {
      expect(decoded.count > 0 && decoded.count <= FaceBatch::capacity, "a batch has faces");
      expect(decoded.first == faces.count, "batches follow each other");
      for (std::size_t i = 0; i < decoded.count; ++i) {
        std::uint64_t hash = mixed_hash(static_cast<std::uint64_t>(decoded.status[i]));
        for (std::size_t corner = 0; corner < 3 && decoded.status[i] == FaceStatus::good;
             ++corner) {
          for (const double x : decoded.corner(corner, i))
            hash = mixed_hash(hash ^ std::bit_cast<std::uint64_t>(x));
          for (std::size_t k = 0; k < reader.facts().choice.carried.size(); ++k)
            hash = mixed_hash(hash ^ std::bit_cast<std::uint64_t>(decoded.attribute(k, corner, i)));
        }
        faces.sum = mixed_hash(faces.sum ^ hash);
      }
      faces.count += decoded.count;
    });
    expect(faces.count < most_faces, "faces have bytes");
  }
  return faces;
}

// Nothing where the content was refused.
std::optional<Faces> read(const std::string& content, test::MemorySource::Kind kind, Access access,
                          std::size_t batch_faces) {
  FuzzJob fuzz;
  std::optional<Faces> faces;
  survives([&] {
    AttributeRequest wish;
    wish.names.reset();
    const auto reader =
        open_reader(fuzz.job, std::make_unique<test::MemorySource>(content, kind),
                    Format::automatic, access, {std::uint64_t{1} << 20, batch_faces}, wish);
    const std::size_t carried = reader->facts().choice.carried.size();
    expect(reader->attribute_ranges().size() == carried, "every attribute has a range");
    if (access != Access::once) {
      FaceBatch slice;
      reader->begin_positions(PassCorners::all);
      for (RawBatch batch; reader->next_positions(batch); batch = {})
        reader->decode_positions(batch, slice, [](const PositionView&) {});
      (void)reader->first_finite_position();
    }
    const Faces found = faces_of(*reader);
    if (access == Access::repeatedly)
      expect(faces_of(*reader) == found, "a second pass gives the same");
    faces = found;
  });
  return faces;
}

}  // namespace

void read_mesh(std::span<const std::byte> bytes) {
  using Kind = test::MemorySource::Kind;
  const std::string content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::optional<Faces> file = read(content, Kind::file, Access::repeatedly, 8192);
  expect(read(content, Kind::file, Access::once, 5) == file, "small batches give the same");
  // Only a file tells beforehand that something is missing which nobody asks for.
  const std::optional<Faces> pipe = read(content, Kind::pipe, Access::positions_first, 8192);
  expect(pipe == file || !file, "a pipe gives the same");
}

}  // namespace winnow::fuzz
