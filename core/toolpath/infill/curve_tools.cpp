#include "toolpath/infill/curve_tools.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "geometry/polyline.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// The first point of a closed curve is also the last.
std::size_t verticesOf(const SurfaceCurve& c) {
  return c.points.size() + (c.closed ? 1 : 0);
}

// A curve parametrized by arc length [mm]. A closed curve accepts any s, an open one clamps it.
class ByLength {
public:
  explicit ByLength(const SurfaceCurve& c) : curve_(c) {
    s_ = geometry::arcLengths(verticesOf(c), [this](std::size_t i) { return point(i); });
  }
  double length() const { return s_.back(); }
  const std::vector<double>& knots() const { return s_; }
  const Vector3d& point(std::size_t i) const {
    return curve_.points[i % curve_.points.size()].position;
  }
  // `near`: index of the interval between knots where the search starts; set to the interval found.
  // Efficient for increasing lengths.
  SurfacePoint at(double s, std::size_t& near) const {
    if (curve_.closed && (s < 0.0 || s >= length())) {
      s = std::fmod(s, length());
      s = s < 0 ? s + length() : s;
    }
    s = std::clamp(s, 0.0, length());
    const auto [i, t] = geometry::placeAtLength(s_, s, near);
    near = i;
    return {(1 - t) * point(i) + t * point(i + 1),
            curve_.points[i % curve_.points.size()].triangle};
  }

private:
  const SurfaceCurve& curve_;
  std::vector<double> s_;
};

// Returns the arc lengths of corners: local maxima of the turn between the chords before and after.
std::vector<double> findCorners(const ByLength& c, bool closed, const ResampleOptions& o) {
  if (o.cornerRad >= base::kPi)
    return {};
  const double window = std::min(o.cornerWindowMm, c.length() / 8);
  // The exact turn of straighter places is not needed.
  const double straight = (1.0 + 1e-9) * std::max(0.0, std::cos(o.cornerRad));
  std::size_t back = 0, ahead = 0;
  std::vector<double> s, bend;
  for (std::size_t i = 0; i < c.knots().size(); ++i) {
    const double at = c.knots()[i];
    if (closed ? i + 1 == c.knots().size() // Wrap to the first knot
               : at < window || at > c.length() - window)
      continue;
    if (!s.empty() && at - s.back() < 0.02)
      continue;
    const Vector3d& p = c.point(i);
    const Vector3d before = p - c.at(at - window, back).position,
                   after = c.at(at + window, ahead).position - p;
    const double along = before.dot(after);
    const bool isStraight =
        along > 0.0 &&
        along * along > straight * straight * before.squaredNorm() * after.squaredNorm();
    s.push_back(at);
    bend.push_back(isStraight ? 0.0 : geometry::angleBetween(before, after));
  }
  std::vector<double> corners;
  for (std::size_t i = 0; i < s.size(); ++i) {
    bool peak = bend[i] > o.cornerRad;
    for (std::size_t j = i; peak && j-- > 0 && s[i] - s[j] < window;)
      peak = bend[j] <= bend[i];
    for (std::size_t j = i + 1; peak && j < s.size() && s[j] - s[i] < window; ++j)
      peak = bend[j] < bend[i];
    if (peak && (corners.empty() || s[i] - corners.back() > window))
      corners.push_back(s[i]);
  }
  if (closed && corners.size() > 1 && corners.front() + c.length() - corners.back() < window)
    corners.pop_back();
  return corners;
}

bool chordsHold(const ByLength& c, double s0, double s1, int n, double tolerance) {
  if (tolerance == INFINITY)
    return true;
  const auto& knots = c.knots();
  auto it = std::upper_bound(knots.begin(), knots.end(), s0);
  std::size_t near = 0;
  for (int i = 0; i < n; ++i) {
    const double from = s0 + (s1 - s0) * i / n, to = s0 + (s1 - s0) * (i + 1) / n;
    const Vector3d a = c.at(from, near).position, b = c.at(to, near).position;
    for (; it != knots.end() && *it < to; ++it) {
      const Vector3d knot = c.point(static_cast<std::size_t>(it - knots.begin()));
      if (geometry::distanceToSegment(knot, a, b) > tolerance)
        return false;
    }
  }
  return true;
}

void fillStretch(const ByLength& c, double s0, double s1, const ResampleOptions& o,
                 std::vector<double>& out) {
  int n = std::max(1, static_cast<int>(std::ceil((s1 - s0) / o.stepMm - 1e-6)));
  if (!chordsHold(c, s0, s1, n, o.chordMm)) {
    if (s1 - s0 > 2 * o.stepMm) {
      const double middle = 0.5 * (s0 + s1);
      fillStretch(c, s0, middle, o, out);
      fillStretch(c, middle, s1, o, out);
      return;
    }
    while ((s1 - s0) / (n + 1) >= o.shortestMm && !chordsHold(c, s0, s1, n, o.chordMm))
      ++n;
  }
  for (int i = 0; i < n; ++i)
    out.push_back(s0 + (s1 - s0) * i / n);
}
} // namespace

double lengthOf(const SurfaceCurve& c) {
  return geometry::polylineLength(
      verticesOf(c), [&](std::size_t i) { return c.points[i % c.points.size()].position; });
}

Resampled resample(const PatchSurface& surface, const SurfaceCurve& curve,
                   const ResampleOptions& o) {
  base::require(curve.points.size() >= 2, "a curve has two points or more");
  const ByLength c(curve);
  const std::vector<double> corners = findCorners(c, curve.closed, o);
  std::vector<double> arcLengths;
  if (curve.closed) {
    // Start at the first corner, so that no stretch contains one.
    const double start = corners.empty() ? 0.0 : corners.front();
    for (std::size_t i = 0; i < std::max<std::size_t>(corners.size(), 1); ++i) {
      const double s0 = corners.empty() ? start : corners[i];
      const double s1 = i + 1 < corners.size() ? corners[i + 1] : start + c.length();
      // The knots of the wrapped part precede the start; the chord test needs them unwrapped.
      if (s1 <= c.length() + 1e-9) {
        fillStretch(c, s0, s1, o, arcLengths);
      } else {
        fillStretch(c, s0, c.length(), o, arcLengths);
        if (start > 1e-9)
          fillStretch(c, 0.0, start, o, arcLengths);
      }
    }
  } else {
    double s0 = 0.0;
    for (const double corner : corners) {
      fillStretch(c, s0, corner, o, arcLengths);
      s0 = corner;
    }
    fillStretch(c, s0, c.length(), o, arcLengths);
    arcLengths.push_back(c.length());
  }
  // A loop shorter than a step stays a loop.
  if (curve.closed && arcLengths.size() < 3)
    arcLengths = {0.0, c.length() / 3.0, 2.0 * c.length() / 3.0};
  Resampled r;
  r.curve.closed = curve.closed;
  std::size_t near = 0;
  constexpr double kSame = 1e-9; // mm
  for (const double s : arcLengths) {
    const SurfacePoint raw = c.at(s, near);
    r.curve.points.push_back(surface.project(raw.position, raw.triangle));
    const auto corner = std::ranges::upper_bound(corners, s - kSame);
    r.corner.push_back(corner != corners.end() && *corner < s + kSame);
  }
  return r;
}

void smoothCurve(const PatchSurface& surface, SurfaceCurve& curve, const std::vector<char>& fixed,
                 int passes) {
  const std::size_t n = curve.points.size();
  if (n < 3)
    return;
  for (int pass = 0; pass < passes; ++pass) {
    const SurfaceCurve old = curve;
    for (std::size_t i = 0; i < n; ++i) {
      if (fixed[i] || (!curve.closed && (i == 0 || i + 1 == n)))
        continue;
      const Vector3d &a = old.points[(i + n - 1) % n].position, &b = old.points[i].position,
                     &c = old.points[(i + 1) % n].position;
      curve.points[i] = surface.project(0.25 * a + 0.5 * b + 0.25 * c, old.points[i].triangle);
    }
  }
}

} // namespace voluta::toolpath
