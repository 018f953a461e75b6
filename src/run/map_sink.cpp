#include "run/map_sink.hpp"

#include <winnow/error.hpp>

#include "io/same_place.hpp"
#include "io/spool_records.hpp"
#include "mesh/vertex_map.hpp"
#include "options/level_targets.hpp"

#include <algorithm>
#include <new>
#include <span>
#include <vector>

namespace winnow {

namespace {

// The format of numpy.save(), version 1.0; the header ends at a multiple of 64.
std::string npy_header(std::uint64_t count) {
  constexpr std::size_t before = 10;  // the magic, the version, the length of what follows
  std::string text =
      "{'descr': '<i8', 'fortran_order': False, 'shape': (" + std::to_string(count) + ",), }";
  text.append(63 - (before + text.size()) % 64, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() % 256);
  header += static_cast<char>(text.size() / 256);
  return header + text;
}

// Calls take(int64 numbers) for all of them, part by part.
template <typename Take>
void for_each_part(Job& job, const Spool& map, const Take& take) {
  const std::uint64_t vertices = record_count<Destination>(map);
  job.progress.begin("write map", vertices, "vertices");
  std::vector<std::int64_t> part;
  for (std::uint64_t first = 0; first < vertices; first += part.size()) {
    const std::vector<Destination> numbers = read_records<Destination>(
        map, first, std::min<std::uint64_t>(chunk_records, vertices - first));
    part.clear();
    for (const Destination number : numbers)
      part.push_back(number == nowhere ? -1 : std::int64_t{number});
    take(std::span<const std::int64_t>(part));
    job.progress.advance(part.size());
  }
}

}  // namespace

MapSinks open_maps(Job& job, const SimplifyOptions& options, const ResultSinks& meshes,
                   const Replaces& replaces, const char* way_out) {
  if (options.map == "-") throw Error(ErrorKind::usage, "`map` takes the name of a file, not '-'");
  const std::vector<std::string> names = map_names(options);
  for (const auto& mesh : meshes) {
    if (names.empty()) break;
    if (!mesh->encoder().numbers_vertices()) {
      throw Error(ErrorKind::usage,
                  "`map` gives numbers of vertices, and the output has none of its own or repeats "
                  "them (" +
                      mesh->format() + "); choose a PLY, an OBJ or an OFF");
    }
    for (const std::string& name : names) {
      if (same_place(name, mesh->name()))
        throw Error(ErrorKind::usage, "the output and its `map` need a name each");
    }
  }
  MapSinks maps;
  for (const std::string& name : names) {
    const bool force = options.force || (replaces && replaces(maps.size(), name));
    maps.push_back(std::make_unique<MapFile>(job, name, force, way_out));
  }
  return maps;
}

void MapFile::write(Job& job, const Spool& map) {
  const std::string header = npy_header(record_count<Destination>(map));
  sink_.write(std::as_bytes(std::span(header)));
  for_each_part(job, map,
                [&](std::span<const std::int64_t> part) { sink_.write(std::as_bytes(part)); });
  sink_.flush_and_sync();
}

void MapArray::write(Job& job, const Spool& map) {
  map_.clear();
  try {
    map_.reserve(record_count<Destination>(map));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::resources,
                "there is no memory for the map of vertices, which the budget does not count");
  }
  for_each_part(job, map, [&](std::span<const std::int64_t> part) {
    map_.insert(map_.end(), part.begin(), part.end());
  });
}

}  // namespace winnow
