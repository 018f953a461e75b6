// Formats that are taken in whole before anything is given out: their vertices and triangles wait
// in memory or, where they do not fit, in scratch. So vertices and faces may stand in any order,
// and every pass after the first is free of parsing, from files and pipes alike.
#pragma once

#include "read/indexed/buffered_faces.hpp"
#include "read/indexed/reader.hpp"
#include "read/indexed/vertex_numbers.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace winnow {

// Stands for every index of no vertex.
constexpr std::uint32_t no_vertex = UINT32_MAX;

// What a format's parser fills, by one thread at a time.
class BufferedMesh {
 public:
  BufferedMesh(Job& job, VertexStore& vertices, BufferedFaces& faces, VertexNumbers& numbers,
               std::vector<bool> carried, std::string name)
      : job_(job),
        vertices_(vertices),
        faces_(faces),
        numbers_(numbers),
        carried_(std::move(carried)),
        name_(std::move(name)) {}

  // Of each attribute that the format offered whether it is carried.
  [[nodiscard]] const std::vector<bool>& carried() const { return carried_; }

  // `single`: floats say the same. A mesh of which all vertices are single is one of floats.
  // `attributes`: those that are carried, vertex by vertex.
  void add_vertices(std::span<const double> xyz, bool single,
                    std::span<const double> attributes = {});
  // By which the corners of faces name vertices, if at all; else they count them from 0.
  void add_numbers(std::span<const std::uint32_t> numbers) { numbers_.add(numbers); }
  void add_polygon(std::span<const std::uint32_t> corners) { faces_.add_polygon(corners); }
  void add_triangles(std::span<const std::uint32_t> corners) { faces_.add(corners); }  // three each

  // Not all vertices have what was offered, so none carries it.
  void drop_attributes() { attributes_dropped_ = true; }
  [[nodiscard]] bool attributes_dropped() const { return attributes_dropped_; }

  // What the parser comes across and does not read, in words, each once.
  void pass_over(const std::string& what);
  [[nodiscard]] const std::vector<std::string>& passed_over() const { return passed_over_; }

  // Points that are no corners of faces, and are not among the vertices.
  void leave_out_points(std::uint64_t count) { points_ += count; }
  [[nodiscard]] std::uint64_t points() const { return points_; }

  [[nodiscard]] std::uint64_t vertices() const { return vertices_.size(); }
  [[nodiscard]] bool single() const { return single_; }
  [[nodiscard]] Job& job() const { return job_; }
  [[nodiscard]] const std::string& name() const { return name_; }  // of the input, for messages

 private:
  Job& job_;
  VertexStore& vertices_;
  BufferedFaces& faces_;
  VertexNumbers& numbers_;
  std::vector<bool> carried_;
  std::string name_;
  std::uint64_t points_ = 0;
  bool single_ = true;
  bool attributes_dropped_ = false;
  std::vector<std::string> passed_over_;
};

class BufferedReader : public IndexedReader {
 public:
  // Reads the whole source into the mesh. `offer`: by the first bytes of the source.
  using Parse =
      std::function<void(ByteSource& source, std::size_t batch_faces, BufferedMesh& mesh)>;

  BufferedReader(Job& job, std::unique_ptr<ByteSource> source, const ReaderMemory& memory,
                 const AttributeRequest& wish, const std::string& format,
                 const AvailableAttributes& offer, const Parse& parse);

  [[nodiscard]] std::uint64_t bytes() const override {
    return source_->size().value_or(source_->position());
  }
  void check_whole() const override {
    IndexedReader::check_whole();
    job_.watched.check();
  }

 protected:
  void begin_indices() override { next_kept_ = 0; }
  bool next_indices(RawBatch& batch) override;
  bool sample_indices(double place, RawBatch& batch) override;
  [[nodiscard]] bool faces_come_again() const override { return true; }

 private:
  bool read_faces(std::uint64_t first, RawBatch& batch);

  BufferedFaces faces_;
  VertexNumbers numbers_;
  std::uint64_t next_kept_ = 0;
};

}  // namespace winnow
