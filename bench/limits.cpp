// What this machine allows: the yardstick for every rate that winnow reports.
//   bench_limits FILE [--threads N] [--repeats N] [--only sums|warm|reads|memory]
// A loop that maps the file and only sums what a simplifier must at least look at, in million faces
// a second for 1..N threads (mapping, page faults and unmapping counted); reading the file warm,
// cold and past the page cache; and the memory itself, read, copied and in STREAM's triad. Of every
// limit the best of several runs is given, null where it cannot be had.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <functional>
#include <thread>

#include <sys/mman.h>
#include <sys/sysinfo.h>

namespace {

using bench::Layout;
using Slice =
    std::function<double(const unsigned char* file, std::uint64_t part, std::uint64_t parts)>;

double best_of(unsigned repeats, const std::function<double()>& rate) {
  double best = 0;
  for (unsigned i = 0; i < repeats; ++i) best = std::max(best, rate());
  return best;
}

// The results of timed loops go here, so that no loop is left out as unused.
volatile double sink;

void in_threads(unsigned threads, const std::function<double(unsigned)>& work) {
  std::vector<double> results(threads);
  std::vector<std::thread> pool;
  for (unsigned i = 0; i < threads; ++i) pool.emplace_back([&, i] { results[i] = work(i); });
  for (auto& thread : pool) thread.join();
  for (const double result : results) sink = sink + result;
}

// Sums in many independent lanes: one chain of additions would be slower than the memory it
// measures.
template <std::size_t N>
struct Lanes {
  std::array<float, N> sums{};
  void add(const unsigned char* numbers) {
    const auto values = bench::load<std::array<float, N>>(numbers);
    for (std::size_t i = 0; i < N; ++i) sums[i] += values[i];
  }
  double total() const {
    double total = 0;
    for (const float sum : sums) total += double(sum);
    return total;
  }
};

struct Range {
  std::uint64_t begin, end;
};
Range share(std::uint64_t count, std::uint64_t part, std::uint64_t parts) {
  return {count * part / parts, count * (part + 1) / parts};
}

double sum_corners(const Layout& layout, const unsigned char* file, Range faces) {
  Lanes<9> lanes;
  for (std::uint64_t i = faces.begin; i < faces.end; ++i) {
    lanes.add(file + layout.faces_at + i * layout.face_stride + layout.corners_at);
  }
  return lanes.total();
}

double sum_vertices(const Layout& layout, const unsigned char* file, Range vertices) {
  Lanes<1> x, y, z;
  for (std::uint64_t i = vertices.begin; i < vertices.end; ++i) {
    const unsigned char* vertex = file + layout.vertices_at + i * layout.vertex_stride;
    x.add(vertex + layout.xyz_at[0]);
    y.add(vertex + layout.xyz_at[1]);
    z.add(vertex + layout.xyz_at[2]);
  }
  return x.total() + y.total() + z.total();
}

double sum_packed_vertices(const Layout& layout, const unsigned char* file, Range vertices) {
  Lanes<12> lanes;  // four vertices at a time; up to three at the end do not matter
  for (std::uint64_t i = vertices.begin; i + 4 <= vertices.end; i += 4) {
    lanes.add(file + layout.vertices_at + i * 12);
  }
  return lanes.total();
}

double sum_indices(const Layout& layout, const unsigned char* file, Range faces) {
  std::array<std::uint64_t, 3> sums{};
  for (std::uint64_t i = faces.begin; i < faces.end; ++i) {
    const unsigned char* face = file + layout.faces_at + i * layout.face_stride + layout.indices_at;
    const auto indices = bench::load<std::array<std::uint32_t, 3>>(face);
    for (std::size_t k = 0; k < 3; ++k) sums[k] += indices[k];
  }
  return double(sums[0] + sums[1] + sums[2]);
}

double sum_through_indices(const Layout& layout, const unsigned char* file, Range faces) {
  std::array<Lanes<3>, 3> corners;
  for (std::uint64_t i = faces.begin; i < faces.end; ++i) {
    const unsigned char* face = file + layout.faces_at + i * layout.face_stride + layout.indices_at;
    const auto indices = bench::load<std::array<std::uint32_t, 3>>(face);
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k].add(file + layout.vertices_at + indices[k] * layout.vertex_stride +
                     layout.xyz_at[0]);
    }
  }
  return corners[0].total() + corners[1].total() + corners[2].total();
}

class Bench {
 public:
  Bench(const std::string& path, unsigned threads, unsigned repeats)
      : path_(path), file_(path), layout_(file_.layout()), threads_(threads), repeats_(repeats) {
    if (!layout_.is_ply) return;
    const bool adjacent = layout_.xyz_at[1] == layout_.xyz_at[0] + 4 &&
                          layout_.xyz_at[2] == layout_.xyz_at[1] + 4 && !layout_.is_double;
    if (!adjacent) throw std::runtime_error("the loops are written for float x, y, z side by side");
    file_.read_indices();  // checks them: the loop below must not look outside the file
  }

  bench::Json run(const std::string& only) {
    bench::Json json;
    json.add("file", path_).add("faces", layout_.faces).add("bytes", layout_.bytes);
    if (only.empty() || only == "sums") json.add("map_and_sum_mtri_s", all_sums());
    if (only.empty() || only == "warm") {
      json.add("read_warm_gb_s", best_of(repeats_, [&] { return read_rate(0, 256 << 10); }));
    }
    if (only.empty() || only == "reads") {
      json.add("read_cold_gb_s", best_of(repeats_, [&] { return cold_read_rate(0, 1 << 20); }));
      json.add("read_direct_gb_s", direct_rate());
    }
    if (only.empty() || only == "memory") {
      const Memory memory = memory_rates();
      json.add("memory_read_gb_s", memory.reading)
          .add("memory_copy_gb_s", memory.copying)
          .add("memory_triad_gb_s", memory.triad);
    }
    return json;
  }

 private:
  bench::Json all_sums() {
    const Slice corners = [this](const unsigned char* file, std::uint64_t part,
                                 std::uint64_t parts) {
      return sum_corners(layout_, file, share(layout_.faces, part, parts));
    };
    const Slice straight = [this](const unsigned char* file, std::uint64_t part,
                                  std::uint64_t parts) {
      const Range vertices = share(layout_.vertices, part, parts);
      const double sum = layout_.packed_floats() ? sum_packed_vertices(layout_, file, vertices)
                                                 : sum_vertices(layout_, file, vertices);
      return sum + sum_indices(layout_, file, share(layout_.faces, part, parts));
    };
    const Slice through_indices = [this](const unsigned char* file, std::uint64_t part,
                                         std::uint64_t parts) {
      return sum_through_indices(layout_, file, share(layout_.faces, part, parts));
    };
    bench::Json sums;
    if (!layout_.is_ply) return sums.add("corners", map_and_sum(corners));
    return sums.add("straight", map_and_sum(straight))
        .add("through_indices", map_and_sum(through_indices));
  }

  // "mapped" takes a page fault for every few pages; in "populated" every thread first asks the
  // kernel to map its share in one go.
  bench::Json map_and_sum(const Slice& slice) {
    bench::Json mapped, populated;
    for (unsigned threads = 1; threads <= threads_; ++threads) {
      const std::string name = std::to_string(threads);
      mapped.add(name, best_of(repeats_, [&] { return sum_rate(slice, threads, false); }));
      populated.add(name, best_of(repeats_, [&] { return sum_rate(slice, threads, true); }));
    }
    return bench::Json().add("mapped", mapped).add("populated", populated);
  }

  // Million faces a second, with a fresh mapping.
  double sum_rate(const Slice& slice, unsigned threads, bool populate) {
    bench::Stopwatch watch;
    void* map = ::mmap(nullptr, layout_.bytes, PROT_READ, MAP_SHARED, file_.fd(), 0);
    if (map == MAP_FAILED) throw std::runtime_error("cannot map the file");
    auto* bytes = static_cast<unsigned char*>(map);
    in_threads(threads, [&](unsigned i) {
      constexpr std::uint64_t kPage = 4096;
      const Range pages = share((layout_.bytes + kPage - 1) / kPage, i, threads);
      if (populate) {
        ::madvise(bytes + pages.begin * kPage, (pages.end - pages.begin) * kPage,
                  MADV_POPULATE_READ);
      }
      return slice(bytes, i, threads);
    });
    ::munmap(map, layout_.bytes);
    return double(layout_.faces) / 1e6 / watch.lap();
  }

  // GB/s of reading the whole file in order.
  double read_rate(int flags, std::size_t block_bytes) {
    const int fd = ::open(path_.c_str(), O_RDONLY | flags);
    if (fd < 0) return 0;
    constexpr std::size_t kAlignment = 4096;
    bench::Array<char> memory(block_bytes + kAlignment);
    void* block = memory.data();
    std::size_t room = memory.size();
    std::align(kAlignment, block_bytes, block, room);
    bench::Stopwatch watch;
    ssize_t got = 0;
    while ((got = ::read(fd, block, block_bytes)) > 0) sink = sink + *static_cast<char*>(block);
    const double seconds = watch.lap();
    ::close(fd);
    return got < 0 ? 0 : double(layout_.bytes) / 1e9 / seconds;
  }

  double cold_read_rate(int flags, std::size_t block_bytes) {
    ::fdatasync(file_.fd());  // dirty pages would stay
    ::posix_fadvise(file_.fd(), 0, 0, POSIX_FADV_DONTNEED);
    return read_rate(flags, block_bytes);
  }

  // Past the page cache (and with nothing in it, which the kernel would have to respect), with the
  // block that suits the disk best.
  double direct_rate() {
    double best = 0;
    for (const std::size_t block : {1u << 20, 4u << 20, 16u << 20}) {
      best = std::max(best, best_of(repeats_, [&] { return cold_read_rate(O_DIRECT, block); }));
    }
    return best > 0 ? best : HUGE_VAL;  // not every file system can: null
  }

  struct Memory {
    bench::Json reading, copying, triad;
  };

  // GB/s by threads of reading memory, of copying it, and of a = b + 3 c; read and written bytes
  // count alike, what the processor reads of a line before it writes there does not, as in STREAM.
  Memory memory_rates() {
    struct sysinfo machine {};
    ::sysinfo(&machine);
    const std::uint64_t quarter = std::uint64_t{machine.totalram} * machine.mem_unit / 4;
    const std::size_t count = std::min<std::uint64_t>(quarter / 3, 1 << 30) / 8;
    bench::Array<double> a(count), b(count), c(count);
    std::fill_n(a.data(), count, 0.0);
    std::fill_n(b.data(), count, 1.0);
    std::fill_n(c.data(), count, 2.0);
    const double gb = double(count) * 8 / 1e9;
    const auto by_threads = [&](double arrays, const std::function<double(Range)>& work) {
      bench::Json rates;
      for (unsigned threads = 1; threads <= threads_; ++threads) {
        rates.add(std::to_string(threads), best_of(repeats_, [&] {
                    bench::Stopwatch watch;
                    in_threads(threads, [&](unsigned i) { return work(share(count, i, threads)); });
                    return arrays * gb / watch.lap();
                  }));
      }
      return rates;
    };
    Memory rates;
    rates.reading = by_threads(1, [&](Range part) {
      std::uint64_t sum = 0;  // whole numbers: the compiler may add them in any order, and does
      for (std::uint64_t i = part.begin; i < part.end; ++i)
        sum += std::bit_cast<std::uint64_t>(b[i]);
      return double(sum);
    });
    rates.copying = by_threads(2, [&](Range part) {
      std::memcpy(a.data() + part.begin, b.data() + part.begin, (part.end - part.begin) * 8);
      return a[part.begin];
    });
    rates.triad = by_threads(3, [&](Range part) {
      double* const __restrict out = a.data();
      for (std::uint64_t i = part.begin; i < part.end; ++i) out[i] = b[i] + 3.0 * c[i];
      return out[part.begin];
    });
    return rates;
  }

  std::string path_;
  bench::MeshFile file_;
  const Layout& layout_;
  unsigned threads_, repeats_;
};

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("bench_limits", [&] {
    const bench::Arguments arguments(argc, argv, {}, {"--threads", "--repeats", "--only"});
    if (arguments.files().size() != 1)
      throw std::runtime_error("usage: FILE [--threads N] [--repeats N]");
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const auto threads = static_cast<unsigned>(arguments.number("--threads", cores));
    const auto repeats = static_cast<unsigned>(arguments.number("--repeats", 5));
    Bench(arguments.files()[0], threads, repeats).run(arguments.text("--only", "")).print();
  });
}
