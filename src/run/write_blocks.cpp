#include "run/write_blocks.hpp"

#include "base/memory_shares.hpp"
#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "base/sort_unique.hpp"
#include "io/recent_blocks.hpp"
#include "io/spool.hpp"
#include "run/attributes.hpp"
#include "run/write_mesh.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

namespace winnow {

namespace {

constexpr std::uint64_t block_faces = std::uint64_t{1} << 15;
// At most, when no two faces share a vertex: of each its number, its mark, what it is and what it
// is written as; what it may be packed to; and indices likewise. To order them the encoder takes
// about as much again.
constexpr std::uint64_t block_memory =
    block_faces * 3 *
    (2 * sizeof(std::uint32_t) + sizeof(MeshVertex) + 2 * 24 + 11 * sizeof(std::uint32_t));
// Of normals and colours that are carried, and as what these are written and packed.
constexpr std::uint64_t block_attributes =
    block_faces * 3 * (7 * sizeof(double) + 2 * 4 * sizeof(float));

std::uint64_t memory_of_block(bool attributes) {
  return block_memory + (attributes ? block_attributes : 0);
}

// The faces of a block by the numbers of its own vertices, which are numbered as they first come.
struct OwnNumbers {
  std::vector<std::uint32_t> vertices;  // of the mesh, by their numbers in the block
  std::vector<std::uint32_t> corners;
};

OwnNumbers own_numbers(std::vector<std::uint32_t> corners, const BlockEncoder& encoder) {
  std::vector<std::uint32_t> sorted = corners;
  sort_unique(sorted);
  for (std::uint32_t& corner : corners) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), corner) - sorted.begin();
    corner = static_cast<std::uint32_t>(place);
  }
  encoder.reorder(corners, sorted.size());
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(sorted.size(), none);
  OwnNumbers own;
  own.vertices.reserve(sorted.size());
  for (std::uint32_t& corner : corners) {
    std::uint32_t& mine = number[corner];
    if (mine == none) {
      mine = static_cast<std::uint32_t>(own.vertices.size());
      own.vertices.push_back(sorted[corner]);
    }
    corner = mine;
  }
  own.corners = std::move(corners);
  return own;
}

struct EncodedBlock {
  std::uint64_t number = 0;
  MeshBlock block;
  std::vector<std::byte> bytes;
};

// Of one thread.
struct Readers {
  Readers(const StoredMesh& mesh, const MeshShape& shape) : vertices(*mesh.vertices) {
    if (!shape.attributes.empty())
      attributes.emplace(*mesh.attributes, shape.attributes.size() * sizeof(double));
  }

  VertexIndex::Reader vertices;
  std::optional<RecentBlocks> attributes;
};

}  // namespace

Reservation reserve_block(Job& job, const MeshEncoder& encoder, bool attributes) {
  if (encoder.blocks() == nullptr) return {};
  return job.budget.reserve(memory_of_block(attributes), "packing the output");
}

void write_blocks(Job& job, const StoredMesh& mesh, const MeshShape& shape,
                  const BlockEncoder& encoder, ByteSink& sink) {
  // Two blocks a thread keep all busy; fewer do where the budget is small.
  std::vector<Reservation> reservations;
  while (reservations.size() + 1 < 2 * std::size_t{job.threads}) {
    Reservation more = job.budget.try_reserve(memory_of_block(!shape.attributes.empty()));
    if (!more) break;
    reservations.push_back(std::move(more));
  }
  Spool packed(job, share::left::packing(job.budget.left()));
  PerSlot<Readers> slots(job.threads, [&] { return std::make_unique<Readers>(mesh, shape); });
  const std::uint64_t count = (shape.faces + block_faces - 1) / block_faces;
  std::vector<MeshBlock> blocks;
  const Reservation list = job.budget.reserve(count * sizeof(MeshBlock), "the list of blocks");
  blocks.reserve(count);
  job.progress.begin("pack", shape.faces, "faces");
  std::uint64_t next = 0;
  pipeline<EncodedBlock>(
      reservations.size() + 1,
      [&](EncodedBlock& item) {
        item.number = next++;
        return item.number < count;
      },
      [&](EncodedBlock& item) {
        job.progress.check_cancelled();
        const std::uint64_t first = item.number * block_faces;
        const auto faces = static_cast<std::size_t>(std::min(block_faces, shape.faces - first));
        const OwnNumbers own = own_numbers(faces_of(mesh, first, faces), encoder);
        Readers& readers = slots.local();
        std::vector<MeshVertex> vertices;
        vertices.reserve(own.vertices.size());
        const std::size_t carried = shape.attributes.size();
        std::vector<double> attributes(carried * own.vertices.size());
        std::span<double> left = attributes;
        for (const std::uint32_t vertex : own.vertices) {
          vertices.push_back(finished(readers.vertices.at(vertex)));
          if (carried == 0) continue;
          const std::span<double> values = left.first(carried);
          left = left.subspan(carried);
          const std::span<const std::byte> record = readers.attributes->record(vertex);
          std::memcpy(values.data(), record.data(), record.size());
          finish_attributes(shape, values, vertices.back());
        }
        item.bytes.clear();
        item.block = encoder.encode(shape, vertices, own.corners, item.bytes);
      },
      [&](const EncodedBlock& item) {
        packed.append(item.bytes);
        blocks.push_back(item.block);
        job.progress.advance(item.block.faces);
      });
  packed.finish();
  encoder.header(shape, blocks,
                 [&](std::string_view text) { sink.write(std::as_bytes(std::span(text))); });
  job.progress.begin("write", packed.size(), "bytes");
  packed.for_each_part(1, [&](std::span<const std::byte> part) {
    sink.write(part);
    job.progress.advance(part.size());
  });
}

}  // namespace winnow
