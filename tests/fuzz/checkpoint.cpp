// What a checkpoint holds, with checksums that fit and with the bytes as they are.
#include "base/checksum.hpp"
#include "fuzz/job.hpp"
#include "fuzz/targets.hpp"
#include "io/checkpoint_directory.hpp"
#include "io/journal.hpp"
#include "run/run_request.hpp"
#include "stitch/tried_tiles.hpp"

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace winnow::fuzz {

namespace {

// One directory for all inputs: making one takes longer than all else.
class Place {
 public:
  Place()
      : path_(std::filesystem::temp_directory_path() /
              ("winnow-fuzz-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    directory_ = CheckpointDirectory::begin(fuzz_.job, path_.string());
  }
  ~Place() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  const CheckpointDirectory& directory() const { return *directory_; }

 private:
  std::filesystem::path path_;
  FuzzJob fuzz_;
  std::unique_ptr<CheckpointDirectory> directory_;
};

void read_tiles(const CheckpointDirectory& directory) {
  TriedTiles tiles(&directory, 1, 0);
  for (TriedTile tile; tiles.next(tile);)
    expect(tile.edges.size() == tile.costs.size(), "an edge has its cost");
}

void read_text(const std::string& text) {
  survives([&] {
    const Manifest manifest = Manifest::parse(text, "manifest");
    expect(Manifest::parse(manifest.print(), "manifest").print() == manifest.print(),
           "a manifest comes back");
    survives([&] { (void)request_in(manifest); });
    SimplifyReport report;
    survives([&] { get_report(manifest, report); });
    SequenceReport frames;
    survives([&] { get_report(manifest, frames); });
  });
}

}  // namespace

void read_journal(std::span<const std::byte> bytes) {
  static const Place place;
  const std::string path = place.directory().file("round-1.attempt-0");
  ::truncate(path.c_str(), 0);
  Journal(path).append({bytes});
  read_tiles(place.directory());
  {
    std::ofstream raw(path, std::ios::binary | std::ios::trunc);
    raw.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
  }
  read_tiles(place.directory());
}

void read_manifest(std::span<const std::byte> bytes) {
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  read_text(text);
  const std::string lines = "winnow checkpoint 1\n" + text + "\n";
  read_text(lines + "checksum " + std::to_string(Checksum::of(std::as_bytes(std::span(lines)))) +
            "\n");
}

}  // namespace winnow::fuzz
