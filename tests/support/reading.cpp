#include "support/reading.hpp"

#include "io/arena.hpp"
#include "read/for_each_batch.hpp"
#include "support/sources.hpp"

#include <map>
#include <mutex>
#include <stdexcept>

#include <catch2/catch.hpp>

namespace winnow::test {

namespace {

// What came with the first number it came with; Catch's macros are for one thread.
template <typename Item>
class Collected {
 public:
  void add(std::uint64_t first, std::vector<Item> items) {
    const std::scoped_lock lock(mutex_);
    if (items.empty()) throw std::logic_error("an empty batch");
    if (!parts_.emplace(first, std::move(items)).second)
      throw std::logic_error("two batches of one number");
  }

  std::vector<Item> in_order() {
    std::vector<Item> all;
    for (auto& [first, items] : parts_) {
      if (first != all.size())
        throw std::logic_error("a gap before number " + std::to_string(first));
      all.insert(all.end(), items.begin(), items.end());
    }
    return all;
  }

 private:
  std::mutex mutex_;
  std::map<std::uint64_t, std::vector<Item>> parts_;
};

}  // namespace

std::vector<SeenFace> read_faces(Job& job, MeshReader& reader) {
  Collected<SeenFace> collected;
  const FaceSink sink = [&](const FaceBatch& batch) {
    std::vector<SeenFace> faces;
    bool all_good = true;
    for (std::size_t i = 0; i < batch.count; ++i) {
      faces.push_back(
          {batch.status[i], {batch.corner(0, i), batch.corner(1, i), batch.corner(2, i)}});
      all_good = all_good && batch.status[i] == FaceStatus::good;
    }
    if (all_good != batch.all_good) throw std::logic_error("all_good is wrong");
    collected.add(batch.first, std::move(faces));
  };
  in_arena(job, [&] {
    reader.begin_faces();
    for_each_face_batch(job, reader, sink, {});
  });
  return collected.in_order();
}

std::vector<Point> read_positions(Job& job, MeshReader& reader) {
  const bool corners = !reader.facts().vertices;
  std::array<Collected<Point>, 3> collected;
  const PositionSink sink = [&](const PositionView& view) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < view.count; ++i)
      points.push_back({view.axis[0][i], view.axis[1][i], view.axis[2][i]});
    collected.at(view.corner).add(view.first, std::move(points));
  };
  in_arena(job, [&] { for_each_position_batch(job, reader, sink); });
  std::array<std::vector<Point>, 3> parts{collected[0].in_order(), collected[1].in_order(),
                                          collected[2].in_order()};
  if (!corners) {
    if (!parts[1].empty() || !parts[2].empty()) throw std::logic_error("vertices have no corners");
    return parts[0];
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < parts[0].size(); ++i) {
    for (const auto& part : parts) points.push_back(part.at(i));
  }
  return points;
}

void check_later_passes(Job& job, MeshReader& reader, const ReaderMemory& memory,
                        const std::vector<SeenFace>& faces) {
  const std::uint64_t written = job.scratch.written();
  CHECK(job.budget.used() <= memory.vertices);
  read_positions(job, reader);
  CHECK(job.budget.used() <= memory.vertices);
  REQUIRE(difference(read_faces(job, reader), faces) == "");
  reader.release_memory();
  REQUIRE(difference(read_faces(job, reader), faces) == "");
  CHECK(job.scratch.written() == written);
}

std::vector<SeenFace> faces_of(Job& job, std::unique_ptr<ByteSource> source,
                               const ReadStyle& style) {
  const auto reader = open_reader(job, std::move(source), style.format, style.access, style.memory);
  return read_faces(job, *reader);
}

std::vector<SeenFace> faces_of(const std::string& content, const ReadStyle& style) {
  TestJob test;
  return faces_of(test.job, std::make_unique<MemorySource>(content), style);
}

std::vector<SeenFace> faces_of_pipe(const std::string& content, const ReadStyle& style) {
  TestJob test;
  return faces_of(test.job, std::make_unique<MemorySource>(content, MemorySource::Kind::pipe),
                  style);
}

Carried carried_by(std::unique_ptr<ByteSource> source, std::uint64_t memory,
                   std::uint64_t vertex_memory) {
  TestJob test({.memory = memory});
  AttributeRequest wish;
  wish.names.reset();
  const auto reader = open_reader(test.job, std::move(source), Format::automatic, Access::once,
                                  {vertex_memory, 8192}, wish);
  Carried carried{{}, {}, reader->facts()};
  const std::vector<Attribute>& attributes = carried.facts.choice.carried;
  std::vector<std::vector<double>> columns(attributes.size());
  reader->begin_faces();
  FaceBatch slice;
  for (RawBatch batch; reader->next_faces(batch); batch = {}) {
    reader->decode_faces(batch, slice, [&](const FaceBatch& faces) {
      for (std::size_t k = 0; k < columns.size(); ++k) {
        for (std::size_t i = 0; i < 3 * faces.count; ++i)
          columns[k].push_back(faces.attribute(k, i % 3, i / 3));
      }
    });
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    carried.attributes.push_back(described(attributes[k]));
    carried.numbers.insert(carried.numbers.end(), columns[k].begin(), columns[k].end());
  }
  return carried;
}

}  // namespace winnow::test
