#include "run/detail.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <cmath>

namespace winnow {

namespace {

// Faces that clustering leaves for each that is wanted, if the caller does not say
// (bench/RESULTS.md).
constexpr double usual_detail = 6;
// Clustering is to spare three quarters of the faces; with less to gain than that, what it loses of
// a spongy surface is not worth it (bench/RESULTS.md).
constexpr double worth_clustering = 0.25;
constexpr const char* keeps_pieces = "pieces are to stay, and clustering may join them";
constexpr const char* detail_full = "`detail` full";

std::string few_faces() {
  return "the input has no more than " + grouped(always_full) + " faces";
}

}  // namespace

std::optional<std::uint64_t> faces_wanted(const Target& target, std::uint64_t available) {
  if (target.faces()) return target.faces();
  if (!target.ratio()) return {};
  const double part = *target.ratio() * static_cast<double>(available);
  return std::max<std::uint64_t>(4, static_cast<std::uint64_t>(part + 0.5));
}

Detail detail_for(const SimplifyOptions& options, std::uint64_t available, std::uint64_t target) {
  const double wanted = options.detail.value_or(usual_detail) * static_cast<double>(target);
  const auto all = static_cast<double>(available);
  // Below all there are: `wanted` may be infinite.
  const auto clustered = [&](const char* reason) {
    return Detail{false, static_cast<std::uint64_t>(wanted), reason};
  };
  if (target >= available && wanted >= all)
    return {true, available, grouped(available) + " faces already"};
  if (options.keep_pieces) return {true, available, keeps_pieces};
  if (options.detail && wanted >= all)
    return {true, available,
            std::isinf(*options.detail) ? detail_full : "`detail` asks for all faces"};
  if (options.detail) return clustered("`detail` asks for it");
  if (available <= always_full) return {true, available, few_faces()};
  if (wanted > worth_clustering * all)
    return {true, available, "it would not spare three quarters of the faces"};
  return clustered("it spares three quarters of the faces or more");
}

Detail detail_for_error(const SimplifyOptions& options, std::uint64_t available) {
  if (options.detail) return {true, available, detail_full};
  if (options.keep_pieces) return {true, available, keeps_pieces};
  if (available <= always_full) return {true, available, few_faces()};
  return {false, available, ""};
}

}  // namespace winnow
