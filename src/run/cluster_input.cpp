#include "run/cluster_input.hpp"

#include "cluster/near_welder.hpp"
#include "cluster/resolution.hpp"
#include "run/attributes.hpp"
#include "run/simplify_options.hpp"

#include <memory>
#include <utility>

namespace winnow {

namespace {

// Vertices nearer to each other than this are joined; in model units.
double weld_distance(Job& job, MeshReader& reader, const SimplifyOptions& options) {
  return options.weld->relative ? options.weld->length(measure_box_of_faces(job, reader).diagonal())
                                : options.weld->value;
}

}  // namespace

Clustered cluster_input(Job& job, Input& input, const SimplifyOptions& options,
                        const AttributeRequest& wish, bool map, const MemoryPlan& plan,
                        const Stopwatch& watch) {
  ReaderMemory reading = plan.reader;
  // The first bad face is to be named.
  reading.any_order = !options.strict;
  std::unique_ptr<MeshReader> reader =
      input.reader(options, access_for(options, map), wish, reading);
  TakenAttributes attributes = take_attributes(job, *reader);
  SimplifyReport::Weld weld;
  NearWeldedReader* welded = nullptr;
  if (welds(options)) {
    weld.distance = weld_distance(job, *reader, options);
    std::unique_ptr<NearWeldedReader> near =
        weld_near(job, std::move(reader), weld.distance, plan.weld);
    weld.vertices = near->merged();
    welded = near.get();
    reader = std::move(near);
  }
  Clustering clustering(job, *reader, options, std::move(attributes), plan, weld.vertices > 0);
  const double opened = watch.seconds();
  Clustered clustered = clustering.run();
  SimplifyReport& report = clustered.report;
  if (welded != nullptr) {
    weld.faces = welded->collapsed();
    report.input.cropped_faces -= weld.faces;
  }
  report.weld = weld;
  if (map)
    clustered.map = clustering.map(welded != nullptr ? welded->unwelded() : *reader, clustered);
  report.seconds.read += opened;
  report.seconds.cluster = watch.seconds() - report.seconds.read;
  return clustered;
}

}  // namespace winnow
