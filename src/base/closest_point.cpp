#include "base/closest_point.hpp"

namespace winnow {

namespace {

// The square of the sine of a corner whose triangle may be a line but for rounding.
constexpr double thin = 1e-9;

Point closest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double squared = dot(ab, ab);
  const double along = dot(p - a, ab);
  if (!(along > 0) || !(squared > 0)) return a;
  return along >= squared ? b : a + along / squared * ab;
}

}  // namespace

bool may_be_line(const Point& ab, const Point& ac) {
  const Point normal = cross(ab, ac);
  return dot(normal, normal) <= thin * dot(ab, ab) * dot(ac, ac);
}

Point closest_point(const Point& p, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Point ab = b - a;
  const Point ac = c - a;
  const Point ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Point bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const Point cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2;
  const double vb = d5 * d2 - d1 * d6;
  const double va = d3 * d6 - d5 * d4;
  const double sum = va + vb + vc;
  Point best = a;
  if (va > 0 && vb > 0 && vc > 0 && sum > 0) {
    best = a + vb / sum * ab + vc / sum * ac;
    // Of a line, rounding may take any point for one inside.
    if (!may_be_line(ab, ac)) return best;
  }
  // On a side. Of a needle, rounding can name the wrong one, so the nearest of all three is taken.
  for (const Point& other :
       {closest_on_segment(p, a, b), closest_on_segment(p, a, c), closest_on_segment(p, b, c)}) {
    if (dot(p - other, p - other) < dot(p - best, p - best)) best = other;
  }
  return best;
}

}  // namespace winnow
