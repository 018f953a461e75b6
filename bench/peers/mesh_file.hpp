// Binary meshes for the benches: little-endian PLY and STL, triangles only, in core and fast.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bench {

static_assert(std::endian::native == std::endian::little, "files are read as they lie");

// Memory of a known size that nobody clears before it is filled.
template <class T>
class Array {
 public:
  Array() = default;
  explicit Array(std::size_t size)
      : data_(std::make_unique_for_overwrite<T[]>(size)), size_(size) {}
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void shrink(std::size_t size) { size_ = std::min(size, size_); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  std::unique_ptr<T[]> data_;
  std::size_t size_ = 0;
};

template <class T>
T load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

// Where things lie in a file. Every vertex and every face is a record of fixed size, since all
// faces are triangles. In STL a face is 50 bytes with its nine coordinates at `corners_at`, and
// there are no vertices.
struct Layout {
  bool is_ply = false;
  std::uint64_t bytes = 0, vertices = 0, faces = 0;
  std::uint64_t vertices_at = 0, vertex_stride = 0;
  std::array<std::uint64_t, 3> xyz_at{};  // inside a vertex record
  bool is_double = false;
  std::uint64_t faces_at = 0, face_stride = 0;
  std::uint64_t count_at = 0, indices_at = 0;  // inside a face record of a PLY file
  std::uint64_t corners_at = 0;                // inside a face record of an STL file

  bool packed_floats() const {
    return !is_double && vertex_stride == 12 && xyz_at == std::array<std::uint64_t, 3>{0, 4, 8};
  }
};

namespace detail {

inline std::uint64_t type_size(const std::string& type) {
  for (const char* name : {"char", "uchar", "int8", "uint8"}) {
    if (type == name) return 1;
  }
  for (const char* name : {"short", "ushort", "int16", "uint16"}) {
    if (type == name) return 2;
  }
  for (const char* name : {"int", "uint", "int32", "uint32", "float", "float32"}) {
    if (type == name) return 4;
  }
  for (const char* name : {"double", "float64"}) {
    if (type == name) return 8;
  }
  throw std::runtime_error("unknown PLY type " + type);
}

inline void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

// One `property` line of the vertex element; grows the record.
inline void add_vertex_property(Layout& layout, std::array<bool, 3>& found, const std::string& type,
                                const std::string& name) {
  if (name.size() == 1 && name[0] >= 'x' && name[0] <= 'z') {
    const auto axis = static_cast<std::size_t>(name[0] - 'x');
    require(type.starts_with("float") || type == "double", "positions must be float or double");
    layout.xyz_at[axis] = layout.vertex_stride;
    layout.is_double = type_size(type) == 8;
    found[axis] = true;
  }
  layout.vertex_stride += type_size(type);
}

inline Layout ply_layout(const std::string& header, std::uint64_t header_bytes) {
  Layout layout{.is_ply = true};
  std::array<bool, 3> found{};
  bool found_list = false;
  std::uint64_t skipped = 0, skipped_count = 0;  // elements that stand before the faces
  std::uint64_t* stride = nullptr;
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, type, name;
    words >> word >> type;
    if (word == "format") {
      require(type == "binary_little_endian", "only binary little-endian PLY is read here");
    } else if (word == "element") {
      std::uint64_t count = 0;
      words >> count;
      if (type == "vertex") {
        layout.vertices = count;
        layout.vertices_at = header_bytes + skipped;
        stride = &layout.vertex_stride;
      } else if (type == "face") {
        layout.faces = count;
        skipped += layout.vertices * layout.vertex_stride;
        layout.faces_at = header_bytes + skipped;
        stride = &layout.face_stride;
      } else {
        if (stride == &layout.face_stride) break;  // what follows the faces is of no interest
        require(layout.vertices == 0, "an element between vertices and faces is not read here");
        skipped_count = count;
        stride = nullptr;
      }
    } else if (word == "property" && type == "list") {
      std::string count_type, index_type;
      words >> count_type >> index_type >> name;
      require(stride == &layout.face_stride && !found_list,
              "only one list, in the faces, is read here");
      require(type_size(count_type) == 1 && type_size(index_type) == 4,
              "faces must be uchar + int lists");
      found_list = true;
      layout.count_at = layout.face_stride;
      layout.indices_at = layout.count_at + 1;
      layout.face_stride += 13;
    } else if (word == "property") {
      words >> name;
      if (stride == &layout.vertex_stride) {
        add_vertex_property(layout, found, type, name);
      } else if (stride != nullptr) {
        *stride += type_size(type);
      } else {
        skipped += skipped_count * type_size(type);
      }
    }
  }
  require(found[0] && found[1] && found[2] && found_list,
          "no positions or no faces in this PLY file");
  return layout;
}

}  // namespace detail

// An open mesh file. Reads go through read(2) in blocks that stay in the processor's cache.
class MeshFile {
 public:
  explicit MeshFile(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (fd_ < 0) throw std::runtime_error(path + ": " + std::strerror(errno));
    struct stat status {};
    ::fstat(fd_, &status);
    std::string head(std::min<std::size_t>(static_cast<std::size_t>(status.st_size), 64 << 10),
                     '\0');
    read_at(0, head.data(), head.size());
    if (head.starts_with("ply")) {
      const std::size_t end = head.find("end_header");
      const std::size_t newline = head.find('\n', end);
      detail::require(end != head.npos && newline != head.npos, "the PLY header has no end");
      layout_ = detail::ply_layout(head.substr(0, end), newline + 1);
    } else {
      detail::require(head.size() >= 84, "neither PLY nor binary STL");
      layout_.faces = load<std::uint32_t>(reinterpret_cast<const unsigned char*>(head.data()) + 80);
      layout_.faces_at = 84;
      layout_.face_stride = 50;
      layout_.corners_at = 12;
    }
    layout_.bytes = static_cast<std::uint64_t>(status.st_size);
    detail::require(layout_.faces_at + layout_.faces * layout_.face_stride <= layout_.bytes,
                    "the file is shorter than its header says");
  }
  ~MeshFile() { ::close(fd_); }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;

  int fd() const { return fd_; }
  const Layout& layout() const { return layout_; }

  // PLY: x, y, z of every vertex.
  template <class Real>
  Array<Real> read_vertices() const {
    Array<Real> xyz(layout_.vertices * 3);
    if (std::is_same_v<Real, float> && layout_.packed_floats()) {
      read_at(layout_.vertices_at, xyz.data(), xyz.size() * sizeof(Real));
      return xyz;
    }
    Real* out = xyz.data();
    for_each_record(
        layout_.vertices_at, layout_.vertices, layout_.vertex_stride, [&](const auto* vertex) {
          for (const std::uint64_t at : layout_.xyz_at) {
            *out++ = static_cast<Real>(layout_.is_double ? load<double>(vertex + at)
                                                         : double(load<float>(vertex + at)));
          }
        });
    return xyz;
  }

  // PLY: three vertices of every face, all known to exist.
  Array<std::uint32_t> read_indices() const {
    Array<std::uint32_t> indices(layout_.faces * 3);
    std::uint32_t* out = indices.data();
    std::uint32_t last = 0;
    bool triangles = true;
    for_each_record(layout_.faces_at, layout_.faces, layout_.face_stride, [&](const auto* face) {
      triangles &= face[layout_.count_at] == 3;
      std::memcpy(out, face + layout_.indices_at, 12);
      last = std::max({last, out[0], out[1], out[2]});
      out += 3;
    });
    detail::require(triangles, "only triangles are read here");
    detail::require(layout_.faces == 0 || last < layout_.vertices,
                    "a face names a vertex that is not there");
    return indices;
  }

  // STL: nine coordinates of every face.
  template <class Real>
  Array<Real> read_corners() const {
    Array<Real> corners(layout_.faces * 9);
    Real* out = corners.data();
    for_each_record(layout_.faces_at, layout_.faces, layout_.face_stride, [&](const auto* face) {
      const auto xyz = load<std::array<float, 9>>(face + layout_.corners_at);
      out = std::copy(xyz.begin(), xyz.end(), out);
    });
    return corners;
  }

  template <class Use>
  void for_each_record(std::uint64_t at, std::uint64_t count, std::uint64_t stride, Use use) const {
    const std::uint64_t batch = std::max<std::uint64_t>(1, (256 << 10) / stride);
    Array<unsigned char> block(batch * stride);
    for (std::uint64_t done = 0; done < count; done += batch) {
      const std::uint64_t n = std::min(batch, count - done);
      read_at(at + done * stride, block.data(), n * stride);
      for (std::uint64_t i = 0; i < n; ++i)
        use(static_cast<const unsigned char*>(block.data() + i * stride));
    }
  }

 private:
  void read_at(std::uint64_t at, void* into, std::uint64_t bytes) const {
    char* out = static_cast<char*>(into);
    while (bytes > 0) {
      const ssize_t got = ::pread(fd_, out, bytes, static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) throw std::runtime_error("cannot read the file to its end");
      out += got;
      at += static_cast<std::uint64_t>(got);
      bytes -= static_cast<std::uint64_t>(got);
    }
  }

  int fd_;
  Layout layout_;
};

// Binary little-endian PLY: float positions, uchar + int faces.
inline void write_ply(const std::string& path, const float* xyz, std::size_t vertices,
                      const std::uint32_t* indices, std::size_t faces) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw std::runtime_error(path + ": " + std::strerror(errno));
  std::fprintf(
      file,
      "ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty float x\nproperty float "
      "y\nproperty float z\nelement face %zu\nproperty list uchar int vertex_indices\nend_header\n",
      vertices, faces);
  std::fwrite(xyz, 12, vertices, file);
  std::vector<unsigned char> records(13 * std::min<std::size_t>(faces, 16 << 10));
  for (std::size_t done = 0; done < faces;) {
    const std::size_t n = std::min(faces - done, records.size() / 13);
    for (std::size_t i = 0; i < n; ++i) {
      records[13 * i] = 3;
      std::memcpy(&records[13 * i + 1], indices + 3 * (done + i), 12);
    }
    std::fwrite(records.data(), 13, n, file);
    done += n;
  }
  const bool written = std::ferror(file) == 0;
  if (std::fclose(file) != 0 || !written) throw std::runtime_error(path + ": cannot write");
}

}  // namespace bench
