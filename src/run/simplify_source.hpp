// The pipeline from an open source on, whatever that is: read, cluster, refine, write.
#pragma once

#include <winnow/simplify.hpp>

#include "io/byte_sink.hpp"
#include "io/byte_source.hpp"
#include "io/job.hpp"
#include "write/mesh_encoder.hpp"

#include <memory>
#include <string>

namespace winnow {

// Inside the job's arena. `watch` began with the call; the caller holds reserve_block().
// `output` is what the report calls it.
SimplifyReport simplify_source(Job& job, std::unique_ptr<ByteSource> source,
                               const std::string& output, const MeshEncoder& encoder,
                               ByteSink& sink, const SimplifyOptions& options,
                               const Stopwatch& watch);

}  // namespace winnow
