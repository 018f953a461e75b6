#include "write/colored_ply.hpp"

#include "base/exact_sum.hpp"
#include "base/text.hpp"
#include "base/viridis.hpp"
#include "write/append.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace winnow {

namespace {

constexpr std::size_t flush_at = std::size_t{1} << 18;

double root_mean_square(std::span<const double> squared) {
  ExactSum sum;
  for (const double value : squared) sum.add(value);
  return squared.empty() ? 0 : std::sqrt(sum.value() / static_cast<double>(squared.size()));
}

}  // namespace

void write_colored_ply(Job& job, std::span<const Point> vertices,
                       std::span<const std::array<std::uint32_t, 3>> faces,
                       std::span<const double> squared_distances, double diagonal, ByteSink& sink) {
  const double most = last_color_at(root_mean_square(squared_distances), diagonal);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment distances by winnow compare; yellow is " +
      shortest(most) + " and more\nelement vertex " + std::to_string(vertices.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nproperty float quality\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face " +
      std::to_string(faces.size()) + "\nproperty list uchar " +
      (vertices.size() <= std::size_t{1} << 31 ? "int" : "uint") + " vertex_indices\nend_header\n";
  sink.write(std::as_bytes(std::span(header)));
  job.progress.begin("write", vertices.size() + faces.size(), "elements");
  std::vector<std::byte> bytes;
  const auto flush = [&](std::size_t at_least) {
    if (bytes.size() < at_least) return;
    job.progress.check_cancelled();
    sink.write(bytes);
    bytes.clear();
  };
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const double distance = std::sqrt(squared_distances[v]);
    for (const double coordinate : vertices[v]) append(bytes, coordinate);
    append(bytes, static_cast<float>(distance));
    for (const std::uint8_t channel : viridis(distance, most)) append(bytes, channel);
    flush(flush_at);
  }
  for (const auto& face : faces) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : face) append(bytes, corner);
    flush(flush_at);
  }
  flush(1);
}

}  // namespace winnow
