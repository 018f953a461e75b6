// Where a result goes: a file, or arrays of the caller.
#pragma once

#include <winnow/mesh.hpp>

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "run/write_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace winnow {

class MeshSink {
 public:
  virtual ~MeshSink() = default;

  // Tells what can be held.
  [[nodiscard]] virtual const MeshEncoder& encoder() const = 0;

  // Everything that can fail. Returns the size of the mesh, before compression.
  virtual std::uint64_t write(const StoredMesh& mesh, const MeshShape& shape) = 0;
  virtual void finish() = 0;

  [[nodiscard]] virtual std::string name() const { return {}; }      // of a file, as it was given
  [[nodiscard]] virtual std::string format() const = 0;              // for people
  [[nodiscard]] virtual std::string identity() const { return {}; }  // see ByteSink
};

class FileSink final : public MeshSink {
 public:
  // Holds room for a block, where the format is made of those; the rest of the budget may be
  // divided then. `way_out`: see ByteSink.
  FileSink(Job& job, std::string name, const SimplifyOptions& options,
           const char* way_out = ByteSink::by_force);

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  std::uint64_t write(const StoredMesh& mesh, const MeshShape& shape) override;
  void finish() override { sink_.finish(); }
  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::string format() const override { return format_; }
  [[nodiscard]] std::string identity() const override { return sink_.identity(); }

 private:
  Job& job_;
  std::string name_, format_;
  std::unique_ptr<MeshEncoder> encoder_;
  Reservation packing_;
  ByteSink sink_;
};

// Fills `mesh` with what a binary PLY would have.
class MemorySink final : public MeshSink {
 public:
  // Throws Error(usage) for options that ask for a format.
  MemorySink(Job& job, Mesh& mesh, const SimplifyOptions& options);

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  std::uint64_t write(const StoredMesh& mesh, const MeshShape& shape) override;
  void finish() override {}
  [[nodiscard]] std::string format() const override { return "memory"; }

 private:
  Job& job_;
  Mesh& mesh_;
  std::unique_ptr<MeshEncoder> encoder_;
};

}  // namespace winnow
