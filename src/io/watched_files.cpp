#include "io/watched_files.hpp"

#include "io/file_descriptor.hpp"

#include <sys/stat.h>

namespace winnow {

FileVersion FileVersion::of(const struct stat& status) {
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
          status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

void check_unchanged(const std::string& name, const FileVersion& before, const FileVersion& now) {
  if (now.size < before.size) shortened(name, now.size);
  if (now.size == before.size && now != before) changed(name);
}

void WatchedFiles::add(const std::string& name, const FileVersion& version) {
  const auto [known, is_new] = versions_.try_emplace(name, version);
  if (is_new) return;
  check_unchanged(name, known->second, version);
  if (version != known->second) changed(name);
}

void WatchedFiles::check() const {
  for (const auto& [name, version] : versions_) {
    struct stat now {};
    if (::stat(name.c_str(), &now) == 0) check_unchanged(name, version, FileVersion::of(now));
  }
}

}  // namespace winnow
