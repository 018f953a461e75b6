// Where the map of vertices goes: a file, or an array of the caller.
#pragma once

#include <winnow/mesh.hpp>

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "run/result_sink.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

class MapSink : public Output {
 public:
  // Everything that can fail. `map`: a Destination for each vertex of the input.
  virtual void write(Job& job, const Spool& map) = 0;
};

// One for each result, the finest first; or none.
using MapSinks = std::vector<std::unique_ptr<MapSink>>;

// An array of NumPy: a header that tells the count, and a little-endian int64 a vertex.
class MapFile final : public MapSink {
 public:
  MapFile(Job& job, std::string name, bool force, const char* way_out)
      : name_(std::move(name)), sink_(job, name_, force, way_out) {}

  void write(Job& job, const Spool& map) override;
  void finish() override { sink_.finish(); }
  void finish_for_now() override { sink_.finish_for_now(); }
  void take_back() noexcept override { sink_.take_back(); }
  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::string identity() const override { return sink_.identity(); }

 private:
  std::string name_;
  ByteSink sink_;
};

class MapArray final : public MapSink {
 public:
  explicit MapArray(VertexMap& map) : map_(map) {}

  void write(Job& job, const Spool& map) override;
  void take_back() noexcept override { map_.clear(); }

 private:
  VertexMap& map_;
};

// Whether the file of this number and name is replaced whatever it is.
using Replaces = std::function<bool(std::size_t, const std::string&)>;

// The files that `options` ask for; none where they do not. Throws Error(usage) where names are
// taken, or where the vertices of a mesh are not numbered as the map says.
MapSinks open_maps(Job& job, const SimplifyOptions& options, const ResultSinks& meshes,
                   const Replaces& replaces = {}, const char* way_out = ByteSink::by_force);

}  // namespace winnow
