#include "generate/noise.hpp"

namespace winnow {

namespace {

// Distinct odd multipliers, one an axis; neighbouring cells then differ in many bits (as in
// Teschner et al., "Optimized Spatial Hashing", 2003).
constexpr std::uint32_t multiplier_x = 0x9e3779b1;
constexpr std::uint32_t multiplier_y = 0x85ebca77;
constexpr std::uint32_t multiplier_z = 0xc2b2ae3d;

// Makes every coordinate positive: then the conversion to an integer rounds down.
constexpr double shift = 32768;

struct Cells {
  alignas(64) std::array<std::int32_t, batch_points> cell;
  alignas(64) std::array<float, batch_points> fraction;
};

void locate(const std::array<double, batch_points>& coordinates, std::size_t count,
            double frequency, Cells& cells) {
  for (std::size_t k = 0; k < count; ++k) {
    const double at = coordinates[k] * frequency + shift;
    const auto cell = static_cast<std::int32_t>(at);
    cells.cell[k] = cell;
    cells.fraction[k] = static_cast<float>(at - cell);
  }
}

inline std::uint32_t scramble(std::uint32_t h) {
  h ^= h >> 15;
  h *= 0x2c1b3c6d;
  h ^= h >> 14;
  return h;
}

// The ten bits from bit `from` on, as a number from -511.5 to 511.5.
template <int from>
inline float field(std::uint32_t h) {
  return static_cast<float>(static_cast<std::int32_t>(h >> from & 1023)) - 511.5F;
}

inline float slope(std::uint32_t h, float x, float y, float z) {
  const std::uint32_t s = scramble(h);
  return field<22>(s) * x + field<12>(s) * y + field<2>(s) * z;
}

inline float slope(std::uint32_t h, float x, float y) {
  const std::uint32_t s = scramble(h);
  return field<22>(s) * x + field<12>(s) * y;
}

inline float fade(float t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}
inline float mix(float a, float b, float t) {
  return a + (b - a) * t;
}

}  // namespace

void space_noise(const PointBatch& points, const NoiseOctave& octave, NoiseValues& values) {
  Cells cells_x, cells_y, cells_z;
  locate(points.x, points.count, octave.frequency, cells_x);
  locate(points.y, points.count, octave.frequency, cells_y);
  locate(points.z, points.count, octave.frequency, cells_z);
  for (std::size_t k = 0; k < points.count; ++k) {
    const std::uint32_t x0 =
        static_cast<std::uint32_t>(cells_x.cell[k]) * multiplier_x ^ octave.seed;
    const std::uint32_t x1 =
        static_cast<std::uint32_t>(cells_x.cell[k] + 1) * multiplier_x ^ octave.seed;
    const std::uint32_t y0 = static_cast<std::uint32_t>(cells_y.cell[k]) * multiplier_y;
    const std::uint32_t y1 = y0 + multiplier_y;
    const std::uint32_t z0 = static_cast<std::uint32_t>(cells_z.cell[k]) * multiplier_z;
    const std::uint32_t z1 = z0 + multiplier_z;
    const float x = cells_x.fraction[k];
    const float y = cells_y.fraction[k];
    const float z = cells_z.fraction[k];
    const float u = fade(x);
    const float v = fade(y);
    const float near =
        mix(mix(slope(x0 ^ y0 ^ z0, x, y, z), slope(x1 ^ y0 ^ z0, x - 1, y, z), u),
            mix(slope(x0 ^ y1 ^ z0, x, y - 1, z), slope(x1 ^ y1 ^ z0, x - 1, y - 1, z), u), v);
    const float far = mix(
        mix(slope(x0 ^ y0 ^ z1, x, y, z - 1), slope(x1 ^ y0 ^ z1, x - 1, y, z - 1), u),
        mix(slope(x0 ^ y1 ^ z1, x, y - 1, z - 1), slope(x1 ^ y1 ^ z1, x - 1, y - 1, z - 1), u), v);
    values[k] = mix(near, far, fade(z)) * (1.0F / 512);
  }
}

void plane_noise(const PointBatch& points, const NoiseOctave& octave, NoiseValues& values) {
  Cells cells_x, cells_y;
  locate(points.x, points.count, octave.frequency, cells_x);
  locate(points.y, points.count, octave.frequency, cells_y);
  for (std::size_t k = 0; k < points.count; ++k) {
    const std::uint32_t x0 =
        static_cast<std::uint32_t>(cells_x.cell[k]) * multiplier_x ^ octave.seed;
    const std::uint32_t x1 =
        static_cast<std::uint32_t>(cells_x.cell[k] + 1) * multiplier_x ^ octave.seed;
    const std::uint32_t y0 = static_cast<std::uint32_t>(cells_y.cell[k]) * multiplier_y;
    const std::uint32_t y1 = y0 + multiplier_y;
    const float x = cells_x.fraction[k];
    const float y = cells_y.fraction[k];
    const float u = fade(x);
    values[k] = mix(mix(slope(x0 ^ y0, x, y), slope(x1 ^ y0, x - 1, y), u),
                    mix(slope(x0 ^ y1, x, y - 1), slope(x1 ^ y1, x - 1, y - 1), u), fade(y)) *
                (1.0F / 512);
  }
}

}  // namespace winnow
