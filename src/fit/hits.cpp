#include "fit/hits.hpp"

#include "base/memory_shares.hpp"
#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "fit/face_index.hpp"
#include "io/parted_records.hpp"
#include "io/spool_records.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

namespace {

// Samples that are looked for at once.
constexpr std::uint64_t samples_at_once = 2048;
// Numbers are rounded by adding this: bits behind the point have no room beside it.
constexpr double rounder = 0x1.8p52;
constexpr unsigned most_bits = 50;
// A sample may be so many times as far off as a face is long, in the mean.
constexpr double farthest = 2;

struct PlacedSample {
  std::uint32_t page;
  Point point;

  [[nodiscard]] std::uint64_t rank() const { return page; }
  static bool before(const PlacedSample& a, const PlacedSample& b) { return a.page < b.page; }
  static bool combine(const PlacedSample&, const PlacedSample&) { return false; }
};

// A sample at its nearest face.
struct Hit {
  std::uint32_t face;
  std::array<float, 2> weight;  // of the second and the third corner
  std::array<float, 3> way;     // from the face to the sample, as parts of the farthest

  [[nodiscard]] std::uint64_t rank() const { return face; }
  static bool before(const Hit& a, const Hit& b) { return a.face < b.face; }
  static bool combine(const Hit&, const Hit&) { return false; }
};

// The weights of the second and the third corner at a place of the triangle.
std::array<double, 2> weights_at(const Point& place, const Triangle& t) {
  const Point b = t[1] - t[0];
  const Point c = t[2] - t[0];
  const Point p = place - t[0];
  const double bb = dot(b, b);
  const double bc = dot(b, c);
  const double cc = dot(c, c);
  const double pb = dot(p, b);
  const double pc = dot(p, c);
  const double all = bb * cc - bc * bc;
  if (!(all > 0)) {
    // A line: between the first corner and the farther of the others.
    if (bb >= cc) return {bb > 0 ? std::clamp(pb / bb, 0.0, 1.0) : 0, 0};
    return {0, std::clamp(pc / cc, 0.0, 1.0)};
  }
  const double second = std::clamp((cc * pb - bc * pc) / all, 0.0, 1.0);
  const double third = std::clamp((bb * pc - bc * pb) / all, 0.0, 1 - second);
  return {second, third};
}

// Sums of one face in whole numbers of 2^-bits, so that their order does not matter.
class ExactFaceSums {
 public:
  ExactFaceSums(std::uint32_t face, unsigned bits)
      : face_(face), scale_(std::ldexp(1.0, static_cast<int>(bits))) {}

  [[nodiscard]] std::uint32_t face() const { return face_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double largest_squared() const { return largest_; }

  void add(const Hit& hit) {
    const double second = double{hit.weight[0]};
    const double third = double{hit.weight[1]};
    const std::array<double, 3> weight{1 - second - third, second, third};
    std::size_t at = 0;
    const auto count_in = [&](double value) {
      sum_[at++] += std::bit_cast<std::int64_t>(scale_ * value + rounder) -
                    std::bit_cast<std::int64_t>(rounder);
    };
    for (std::size_t i = 0; i < 3; ++i) count_in(weight[i] * weight[i]);
    for (std::size_t i = 0; i < 3; ++i) count_in(weight[i] * weight[(i + 1) % 3]);
    double squared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const float x : hit.way) count_in(weight[i] * double{x});
    }
    for (const float x : hit.way) squared += double{x} * double{x};
    count_in(squared);
    largest_ = std::max(largest_, squared);
    ++count_;
  }

  void add(const ExactFaceSums& more) {
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += more.sum_[i];
    count_ += more.count_;
    largest_ = std::max(largest_, more.largest_);
  }

  [[nodiscard]] double squares() const { return static_cast<double>(sum_.back()) / scale_; }

  // `reach`: what a way of 1 is.
  [[nodiscard]] FaceSums value(double reach) const {
    FaceSums out;
    std::size_t at = 0;
    const auto next = [&](double unit) {
      return static_cast<float>(static_cast<double>(sum_[at++]) / scale_ * unit);
    };
    for (float& product : out.products) product = next(1);
    for (auto& pull : out.pull) {
      for (float& x : pull) x = next(reach);
    }
    // As the sums are rounded: what is nothing beside faces is 0.
    out.farthest = static_cast<float>(std::round(largest_ * scale_) / scale_ * reach * reach);
    return out;
  }

 private:
  std::uint32_t face_;
  std::uint64_t count_ = 0;
  double largest_ = 0;
  double scale_;
  std::array<std::int64_t, 16> sum_{};
};

class Summer {
 public:
  Summer(Job& job, const StoredMesh& mesh, SampledSurface& samples, std::uint64_t memory,
         Spool& out)
      : job_(job),
        mesh_(mesh),
        samples_(samples),
        memory_(memory),
        out_(out),
        bits_(std::min(most_bits, static_cast<unsigned>(61 - std::bit_width(samples.most())))) {
    const std::uint64_t reading = share::fitting::reading(memory);
    samples.use(reading / job.threads);
  }

  SampleSums run() {
    using Hits = PartedRecords<Hit>;
    const std::uint64_t count = samples_.expected();
    std::optional<Hits> hits;
    const PartsPlan plan =
        Hits::plan(share::fitting::hits(memory_), job_.threads, count, sizeof(ExactFaceSums));
    hits.emplace(job_, plan);
    {
      FaceIndex index(job_, mesh_, share::fitting::index(memory_));
      // A power of two, by which ways can be divided exactly.
      const double face = std::sqrt(index.area() / static_cast<double>(mesh_.face_count));
      if (face > 0) reach_ = std::ldexp(1.0, std::ilogb(farthest * face) + 1);
      PerSlot<Looking> looking(job_.threads, [&] { return std::make_unique<Looking>(index); });
      const auto look_for = [&](std::span<const Point> points) {
        Looking& own = looking.local();
        Hits::Lists& lists = hits->local();
        own.reader.nearest(points, own.found);
        for (std::size_t i = 0; i < points.size(); ++i) {
          const FaceIndex::Nearest& nearest = own.found[i];
          if (!(nearest.squared <= reach_ * reach_)) continue;
          lists.add(nearest.face * plan.parts / mesh_.face_count, hit_of(points[i], nearest));
        }
      };
      job_.progress.begin("fit", count, "samples");
      if (index.in_memory()) {
        for_each_sample(look_for);
      } else {
        // Brought together first, so that few pages are read often.
        using Placed = PartedRecords<PlacedSample>;
        const PartsPlan placing =
            Placed::plan(share::fitting::placed(memory_), job_.threads, count, sizeof(Point));
        Placed placed(job_, placing);
        for_each_sample([&](std::span<const Point> points) {
          for (const Point& point : points) {
            const std::size_t page = index.page_near(point);
            placed.local().add(page * placing.parts / index.pages(),
                               {static_cast<std::uint32_t>(page), point});
          }
        });
        placed.for_each_stretch<std::vector<Point>>(
            [&](std::span<const PlacedSample> stretch, std::vector<Point>& points) {
              while (!stretch.empty()) {
                const std::size_t now = std::min<std::size_t>(stretch.size(), samples_at_once);
                points.clear();
                for (const PlacedSample& sample : stretch.first(now))
                  points.push_back(sample.point);
                look_for(points);
                job_.progress.check_cancelled();
                stretch = stretch.subspan(now);
              }
            },
            [](const std::vector<Point>&) {});
      }
    }
    add_up(*hits);
    return sums_;
  }

 private:
  // What a thread looks with.
  struct Looking {
    explicit Looking(const FaceIndex& index) : reader(index) {}
    FaceIndex::Reader reader;
    std::vector<FaceIndex::Nearest> found;
  };

  // each(points), from several threads.
  template <typename Each>
  void for_each_sample(const Each& each) const {
    std::uint64_t next = 0;
    pipeline<std::uint64_t>(
        job_.threads,
        [&](std::uint64_t& block) {
          block = next++;
          return block < samples_.blocks();
        },
        [&](const std::uint64_t& block) {
          samples_.for_each_part(block, [&](std::span<const Point> points) {
            job_.progress.check_cancelled();
            each(points);
            job_.progress.advance(points.size());
          });
        });
  }

  [[nodiscard]] Hit hit_of(const Point& point, const FaceIndex::Nearest& nearest) const {
    const auto [second, third] = weights_at(nearest.place, nearest.corner);
    const Point way = 1 / reach_ * (point - nearest.place);
    return {static_cast<std::uint32_t>(nearest.face),
            {static_cast<float>(second), static_cast<float>(third)},
            {static_cast<float>(way[0]), static_cast<float>(way[1]), static_cast<float>(way[2])}};
  }

  void add_up(PartedRecords<Hit>& hits) {
    std::optional<ExactFaceSums> last;  // it may go on in the next stretch
    std::uint64_t written = 0;
    std::vector<FaceSums> block;
    const auto flush = [&] {
      append_records<FaceSums>(out_, block);
      block.clear();
      job_.progress.check_cancelled();
    };
    const auto put = [&](const FaceSums& sums) {
      block.push_back(sums);
      ++written;
      if (block.size() == chunk_records) flush();
    };
    const auto end_last = [&] {
      if (!last) return;
      while (written < last->face()) put({});
      put(last->value(reach_));
      sums_.count += last->count();
      sums_.squares += last->squares() * reach_ * reach_;
      sums_.largest = std::max(sums_.largest, std::sqrt(last->largest_squared()) * reach_);
    };
    hits.for_each_stretch<std::vector<ExactFaceSums>>(
        [this](std::span<const Hit> stretch, std::vector<ExactFaceSums>& sums) {
          sums.clear();
          for (const Hit& hit : stretch) {
            if (sums.empty() || sums.back().face() != hit.face) sums.emplace_back(hit.face, bits_);
            sums.back().add(hit);
          }
        },
        [&](const std::vector<ExactFaceSums>& sums) {
          for (const ExactFaceSums& face : sums) {
            if (last && last->face() == face.face()) {
              last->add(face);
            } else {
              end_last();
              last = face;
            }
          }
        });
    end_last();
    while (written < mesh_.face_count) put({});
    flush();
    out_.finish();
  }

  Job& job_;
  const StoredMesh& mesh_;
  const SampledSurface& samples_;
  std::uint64_t memory_;
  Spool& out_;
  unsigned bits_;
  double reach_ = 1;
  SampleSums sums_;
};

}  // namespace

SampleSums sum_up_samples(Job& job, const StoredMesh& mesh, SampledSurface& samples,
                          std::uint64_t memory, Spool& out) {
  return Summer(job, mesh, samples, memory, out).run();
}

}  // namespace winnow
