#include "generate/profile.hpp"

#include "generate/seed_stream.hpp"

#include <cmath>

namespace winnow {

namespace {

// From the crown down. cosine: forward, wide to front and back (negative: wide to the sides),
// three-cornered.
const Ring rough[] = {
    {0.00, 1.03, 0, 0, {0.00, 0.00, 0.00}, {0, 0}},     // crown
    {0.19, 1.00, 0, 0, {-0.04, 0.08, 0.00}, {0, 0}},    //
    {0.34, 0.87, 0, 0, {-0.06, 0.14, 0.00}, {0, 0}},    // forehead
    {0.41, 0.65, 0, 0, {-0.02, 0.14, -0.02}, {0, 0}},   // eyes
    {0.38, 0.43, 0, 0, {0.06, 0.12, 0.02}, {0, 0}},     // cheeks
    {0.30, 0.24, 0, 0, {0.24, 0.08, 0.06}, {0, 0}},     // chin
    {0.18, 0.13, 0, 0, {0.04, 0.03, 0.00}, {0, 0}},     // throat
    {0.18, 0.01, 0, 0, {-0.04, 0.00, 0.00}, {0, 0}},    // neck
    {0.25, -0.09, 0, 0, {-0.06, -0.16, 0.00}, {0, 0}},  //
    {0.52, -0.17, 0, 0, {-0.04, -0.36, 0.00}, {0, 0}},  // shoulders
    {0.63, -0.32, 0, 0, {0.00, -0.34, 0.00}, {0, 0}},   // upper arms
    {0.59, -0.54, 0, 0, {0.06, -0.28, 0.03}, {0, 0}},   // breast
    {0.46, -0.72, 0, 0, {0.06, -0.22, 0.00}, {0, 0}},   //
    {0.24, -0.80, 0, 0, {0.00, -0.05, 0.00}, {0, 0}},   //
    {0.24, -0.88, 0, 0, {0.00, 0.00, 0.00}, {0, 0}},    // foot
    {0.42, -0.92, 0, 0, {0.00, 0.00, 0.00}, {0, 0}},    //
    {0.44, -1.01, 0, 0, {0.00, 0.00, 0.00}, {0, 0}},    //
    {0.25, -1.01, 0, 0, {0.00, 0.00, 0.00}, {0, 0}},    //
    {0.00, -1.01, 0, 0, {0.00, 0.00, 0.00}, {0, 0}},    // middle of the base
};

}  // namespace

Profile::Profile(std::uint32_t seed) : controls_(std::begin(rough), std::end(rough)) {
  SeedStream random(seed);
  for (std::size_t k = 1; k + 3 < controls_.size(); ++k) {
    Ring& ring = controls_[k];
    ring.radius *= random.between(0.93, 1.07);
    for (double& c : ring.cosine) c += random.between(-0.02, 0.02);
    for (double& s : ring.sine) s += random.between(-0.03, 0.03);
  }
  measure();
}

Ring Profile::at(double knot) const {
  const auto last = static_cast<std::int32_t>(controls_.size()) - 1;
  auto segment = static_cast<std::int32_t>(knot);
  if (segment >= last) segment = last - 1;
  const double t = knot - segment;
  const double w = 1 - t;
  const std::array<double, 4> weight{w * w * w / 6, (3 * t * t * (t - 2) + 4) / 6,
                                     (3 * w * w * (w - 2) + 4) / 6, t * t * t / 6};
  const std::array<double, 4> change{-w * w / 2, t * (1.5 * t - 2), w * (2 - 1.5 * w), t * t / 2};
  Ring ring{};
  double out = 0;
  double down = 0;
  for (std::int32_t k = 0; k < 4; ++k) {
    // Beyond its ends the profile goes on as its own mirror image, which makes it smooth at the
    // poles.
    std::int32_t place = segment + k - 1;
    const double side = place < 0 || place > last ? -1 : 1;
    if (place < 0) place = -place;
    if (place > last) place = 2 * last - place;
    const Ring& control = controls_[static_cast<std::size_t>(place)];
    const auto i = static_cast<std::size_t>(k);
    ring.radius += weight[i] * (side * control.radius);
    ring.height += weight[i] * control.height;
    out += change[i] * (side * control.radius);
    down -= change[i] * control.height;
    for (std::size_t n = 0; n < ring.cosine.size(); ++n)
      ring.cosine[n] += weight[i] * control.cosine[n];
    for (std::size_t n = 0; n < ring.sine.size(); ++n) ring.sine[n] += weight[i] * control.sine[n];
  }
  const double length = std::sqrt(out * out + down * down);
  ring.out = down / length;
  ring.up = out / length;
  return ring;
}

Ring Profile::ring(double along) const {
  const double place = along * static_cast<double>(steps);
  auto step = static_cast<std::size_t>(place);
  if (step >= steps) step = steps - 1;
  const double part = place - static_cast<double>(step);
  Ring ring = at(knots_[step] + (knots_[step + 1] - knots_[step]) * part);
  if (along <= 0 || along >= 1) ring.radius = ring.out = 0;  // else rounding leaves 1e-17
  return ring;
}

void Profile::measure() {
  constexpr std::size_t pieces = 4 * steps;
  const double knots = static_cast<double>(controls_.size() - 1);
  std::vector<double> length(pieces + 1, 0.0);
  double area = 0;
  double radius_on_area = 0;
  Ring before = at(0);
  for (std::size_t k = 1; k <= pieces; ++k) {
    const Ring here = at(knots * static_cast<double>(k) / pieces);
    const double dr = here.radius - before.radius;
    const double dh = here.height - before.height;
    const double piece = std::sqrt(dr * dr + dh * dh);
    length[k] = length[k - 1] + piece;
    area += piece * here.radius;
    radius_on_area += piece * here.radius * here.radius;
    before = here;
  }
  std::size_t k = 1;
  for (std::size_t step = 1; step < steps; ++step) {
    const double wanted = length[pieces] * static_cast<double>(step) / steps;
    while (length[k] < wanted) ++k;
    const double part = (wanted - length[k - 1]) / (length[k] - length[k - 1]);
    knots_[step] = knots * (static_cast<double>(k - 1) + part) / pieces;
  }
  knots_[steps] = knots;
  constexpr double full_turn = 6.283185307179586;
  proportion_ = full_turn * (radius_on_area / area) / length[pieces];
}

}  // namespace winnow
