#include "cluster/attribute_means.hpp"

#include "base/parallel.hpp"
#include "base/per_slot.hpp"
#include "cluster/attribute_scale.hpp"
#include "cluster/attribute_sum.hpp"
#include "cluster/cell_table.hpp"
#include "cluster/thread_sums.hpp"

#include <algorithm>
#include <utility>

namespace winnow {

namespace {

// Calls made(std::integral_constant) with the smallest number of attributes that sums are made for.
template <typename Made>
auto with_size(std::size_t attributes, const Made& made) {
  if (attributes <= 4) return made(std::integral_constant<std::size_t, 4>());
  if (attributes <= 8) return made(std::integral_constant<std::size_t, 8>());
  return made(std::integral_constant<std::size_t, most_attributes>());
}

template <typename Sum>
class CursorOf final : public AttributeCursor {
 public:
  CursorOf(std::unique_ptr<RecordCursor<Sum>> sums, const std::vector<AttributeScale>& scales)
      : sums_(std::move(sums)), scales_(scales) {
    more_ = sums_->next(next_);
  }

  void find(CellKey key, std::span<double> means) override {
    while (more_ && next_.key < key) more_ = sums_->next(next_);
    // Weights beyond 2^41 come as several records, of fewer than 2^64 in all.
    Sum whole{};
    for (; more_ && next_.key == key; more_ = sums_->next(next_)) whole.add(next_);
    for (std::size_t i = 0; i < scales_.size(); ++i) {
      const bool label = scales_[i].is_label();
      const std::uint64_t weight = whole.weight - whole.absent[i];
      if (label ? whole.sum[i] == 0 : weight == 0) {
        means[i] = scales_[i].nothing();
      } else if (label) {
        means[i] = static_cast<double>(label_of(whole.sum[i]));
      } else {
        means[i] = scales_[i].mean(whole.sum[i], weight);
      }
    }
  }

 private:
  std::unique_ptr<RecordCursor<Sum>> sums_;
  const std::vector<AttributeScale>& scales_;
  Sum next_{};
  bool more_ = false;
};

template <typename Sum>
class AttributeMeansOf final : public AttributeMeans {
 public:
  AttributeMeansOf(Job& job, const CarriedAttributes& carried, Keys keys,
                   const AttributeMemory& memory)
      : job_(job),
        keys_(keys),
        scales_(scales_of(carried)),
        reserved_(job.budget.reserve(memory.table, "the table of attributes")),
        table_(job, memory.table, memory.table_parts),
        workers_(job.threads, [this] {
          using SumKeys = typename ThreadSums<Sum>::Keys;
          return std::make_unique<ThreadSums<Sum>>(
              table_, keys_ == Keys::cells ? SumKeys::packed_cells : SumKeys::as_they_are);
        }) {}

  void add(const FaceBatch& faces, const CornerSums& corners) override {
    ThreadSums<Sum>& sums = workers_.local();
    for (std::size_t i = 0; i < faces.count; ++i) {
      const std::int64_t kind = corners.kind[i];
      if (faces.status[i] != FaceStatus::good || kind > close_corners) continue;
      if (kind == close_corners && faces.repeats_a_corner(i)) continue;
      Weights weight;
      for (std::size_t c = 0; c < 3; ++c)
        weight[c] = static_cast<std::uint64_t>(corners.weight[c][i]);
      if (kind == one_cell) {
        add_corners(sums, faces, i, static_cast<PackedCell>(corners.cell[0][i]), weight, 0, 3);
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c)
        add_corners(sums, faces, i, static_cast<PackedCell>(corners.cell[c][i]), weight, c, c + 1);
    }
  }

  void add(const FaceBatch& faces, std::size_t face,
           const std::array<std::uint64_t, 3>& numbers) override {
    ThreadSums<Sum>& sums = workers_.local();
    for (std::size_t c = 0; c < 3; ++c)
      add_corners(sums, faces, face, numbers[c], {1, 1, 1}, c, c + 1);
  }

  [[nodiscard]] bool wants_to_spill() const override { return table_.nearly_full(); }
  void spill() override { table_.spill(); }

  std::unique_ptr<AttributeCursor> finish() override {
    const std::vector<ThreadSums<Sum>*> all = workers_.all();
    parallel_for(all.size(), [&all](std::size_t w) { all[w]->finish(); });
    job_.progress.check_cancelled();
    return std::make_unique<CursorOf<Sum>>(table_.finish(), scales_);
  }

 private:
  using Weights = std::array<std::uint64_t, 3>;

  // Corners `from` to `to` of a face, which have one key.
  void add_corners(ThreadSums<Sum>& sums, const FaceBatch& faces, std::size_t face,
                   std::uint64_t key, const Weights& weight, std::size_t from, std::size_t to) {
    std::uint64_t total = 0;
    for (std::size_t c = from; c < to; ++c) total += weight[c];
    Sum& sum = sums.entry(key, total);
    sum.weight += total;
    for (std::size_t k = 0; k < scales_.size(); ++k) {
      if (scales_[k].is_label()) {
        sum.absent[k] = label_mark;
        for (std::size_t c = from; c < to; ++c) {
          const std::int64_t label = scales_[k].fixed(faces.attribute(k, c, face));
          if (label != AttributeScale::none)
            sum.sum[k] = std::max(sum.sum[k], weighed_label(weight[c], label));
        }
        continue;
      }
      Int128 more = 0;
      for (std::size_t c = from; c < to; ++c) {
        const std::int64_t number = scales_[k].fixed(faces.attribute(k, c, face));
        if (number == AttributeScale::none) {
          sum.absent[k] += weight[c];
        } else {
          more += static_cast<Int128>(number) * static_cast<std::int64_t>(weight[c]);
        }
      }
      sum.sum[k] += more;
    }
  }

  Job& job_;
  Keys keys_;
  std::vector<AttributeScale> scales_;
  Reservation reserved_;
  CellTable<Sum> table_;
  PerSlot<ThreadSums<Sum>> workers_;
};

}  // namespace

std::uint64_t AttributeMemory::entry_size(std::size_t attributes) {
  if (attributes == 0) return 0;
  return with_size(attributes, [](auto size) { return std::uint64_t{sizeof(AttributeSum<size>)}; });
}

std::uint64_t AttributeMemory::per_thread(std::size_t attributes) {
  if (attributes == 0) return 0;
  const std::uint64_t sums =
      with_size(attributes, [](auto size) { return ThreadSums<AttributeSum<size>>::memory(); });
  return sums + attributes * sizeof(double) * 3 * FaceBatch::capacity;
}

std::uint64_t AttributeMemory::smallest_table(std::size_t parts, std::size_t attributes) {
  return parts * 4096 * entry_size(attributes);
}

std::unique_ptr<AttributeMeans> AttributeMeans::make(Job& job, const CarriedAttributes& carried,
                                                     Keys keys, const AttributeMemory& memory) {
  return with_size(carried.attributes.size(), [&](auto size) -> std::unique_ptr<AttributeMeans> {
    return std::make_unique<AttributeMeansOf<AttributeSum<size>>>(job, carried, keys, memory);
  });
}

}  // namespace winnow
