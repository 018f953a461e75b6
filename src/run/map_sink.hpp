// Where the map of vertices goes: a file, or an array of the caller.
#pragma once

#include <winnow/mesh.hpp>

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "io/spool.hpp"
#include "run/result_sink.hpp"

#include <memory>
#include <string>

namespace winnow {

class MapSink {
 public:
  virtual ~MapSink() = default;

  // Everything that can fail. `map`: a Destination for each vertex of the input.
  virtual void write(Job& job, const Spool& map) = 0;
  virtual void finish() {}
  virtual void take_back() noexcept {}  // after finish(): nothing of the map stays
  [[nodiscard]] virtual std::string identity() const { return {}; }  // see ByteSink
};

// An array of NumPy: a header that tells the count, and a little-endian int64 a vertex.
class MapFile final : public MapSink {
 public:
  MapFile(Job& job, const std::string& path, bool force, const char* way_out)
      : sink_(job, path, force, way_out) {}

  void write(Job& job, const Spool& map) override;
  void finish() override { sink_.finish(); }
  void take_back() noexcept override { sink_.take_back(); }
  [[nodiscard]] std::string identity() const override { return sink_.identity(); }

 private:
  ByteSink sink_;
};

class MapArray final : public MapSink {
 public:
  explicit MapArray(VertexMap& map) : map_(map) {}

  void write(Job& job, const Spool& map) override;

 private:
  VertexMap& map_;
};

// The file that `options` ask for; null where they do not. `replaces`: whatever is there. Throws
// Error(usage) where there are several outputs, or their vertices are not numbered as the map says.
std::unique_ptr<MapSink> open_map(Job& job, const SimplifyOptions& options,
                                  const ResultSinks& outputs, bool replaces = false,
                                  const char* way_out = ByteSink::by_force);

// The map, which may be null, and the meshes: all appear, or, where one cannot, none.
void finish(const ResultSinks& sinks, MapSink* map);

}  // namespace winnow
