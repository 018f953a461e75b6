// Files of tests: a place for them, their bytes, other forms of the same content.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace winnow::test {

// A directory that goes with the test. On a disk: scratch goes there too.
class Directory {
 public:
  Directory();
  ~Directory();
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] std::vector<std::string> names()
      const;  // of everything in it, hidden files too, sorted

 private:
  std::string path_;
};

bool exists(const std::string& path);
std::uint64_t size_of_file(const std::string& path);
std::string bytes_of_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);

// FNV-1a of all bytes, as 16 digits. Reads the file in parts: large files do not enlarge this
// process, which its children would inherit.
std::string hash_of_file(const std::string& path);

// `path` + ".gz" or ".zst", which is returned.
std::string gzip_file(const std::string& path);
std::string zstd_file(const std::string& path);

// A binary PLY or STL of `winnow generate` as text: floats in the fewest digits that give the same
// float back. A PLY becomes an OBJ, OFF or .m where the other name ends so.
std::string ascii_file(const std::string& path, const std::string& ascii_path);

// A binary PLY of `winnow generate` as a GLB with the same floats.
std::string glb_file(const std::string& path, const std::string& glb_path);

// A PLY of `winnow generate` with its elements the other way round.
std::string faces_first_file(const std::string& path, const std::string& other_path);

}  // namespace winnow::test
