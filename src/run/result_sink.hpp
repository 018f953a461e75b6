// Where a result goes: a file, arrays of the caller, or batches.
#pragma once

#include <winnow/stream.hpp>

#include "io/byte_sink.hpp"
#include "io/job.hpp"
#include "run/write_mesh.hpp"
#include "write/mesh_encoder.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace winnow {

// What appears when all is done, and whole.
class Output {
 public:
  virtual ~Output() = default;

  virtual void finish() {}
  virtual void finish_for_now() {}
  // After finish_for_now(): nothing of it stays.
  virtual void take_back() noexcept {}

  [[nodiscard]] virtual std::string name() const { return {}; }      // of a file, as it was given
  [[nodiscard]] virtual std::string identity() const { return {}; }  // see ByteSink
};

class ResultSink : public Output {
 public:
  // Tells what can be held.
  [[nodiscard]] virtual const MeshEncoder& encoder() const = 0;

  // Everything that can fail. Returns the size of the mesh, before compression.
  virtual std::uint64_t write(const OutputMesh& mesh, const MeshShape& shape) = 0;

  [[nodiscard]] virtual std::string format() const = 0;  // for people
};

// One for each result, the finest first.
using ResultSinks = std::vector<std::unique_ptr<ResultSink>>;

// What `sink` is, opened: as many as there are targets. Files are named as output_names() says.
// Throws Error(usage) where there are several targets, and room for one.
ResultSinks open_sinks(Job& job, const MeshSink& sink, const SimplifyOptions& options);

// Throws Error(usage) where there are several targets and only one mesh is to be given.
void refuse_levels(const SimplifyOptions& options);

class FileSink final : public ResultSink {
 public:
  // Holds room for a block, where the format is made of those; the rest of the budget may be
  // divided then. `way_out`: see ByteSink.
  FileSink(Job& job, std::string name, const SimplifyOptions& options,
           const char* way_out = ByteSink::by_force);

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  std::uint64_t write(const OutputMesh& mesh, const MeshShape& shape) override;
  void finish() override { sink_.finish(); }
  void finish_for_now() override { sink_.finish_for_now(); }
  void take_back() noexcept override { sink_.take_back(); }
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
class MemorySink final : public ResultSink {
 public:
  // Throws Error(usage) for options that ask for a format.
  MemorySink(Job& job, Mesh& mesh, const SimplifyOptions& options);

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  std::uint64_t write(const OutputMesh& mesh, const MeshShape& shape) override;
  void take_back() noexcept override { mesh_ = {}; }
  [[nodiscard]] std::string format() const override { return "memory"; }

 private:
  Job& job_;
  Mesh& mesh_;
  std::unique_ptr<MeshEncoder> encoder_;
};

// The same in batches, one after the other.
class FunctionSink final : public ResultSink {
 public:
  // Throws Error(usage) for options that ask for a format.
  FunctionSink(Job& job, BatchSink take, const SimplifyOptions& options);

  [[nodiscard]] const MeshEncoder& encoder() const override { return *encoder_; }
  std::uint64_t write(const OutputMesh& mesh, const MeshShape& shape) override;
  [[nodiscard]] std::string format() const override { return "memory"; }

 private:
  Job& job_;
  BatchSink take_;
  std::unique_ptr<MeshEncoder> encoder_;
};

}  // namespace winnow
