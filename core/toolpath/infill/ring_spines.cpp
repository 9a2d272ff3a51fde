#include "toolpath/infill/ring_spines.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// Cosines of the largest angle between an end's direction and the line to the other end, or that
// end's direction.
constexpr double kAligned = 0.7;
// Shortest distance [mm] that has a direction.
constexpr double kTouchingMm = 1e-3;

// End 2 k is the front of curve k, 2 k + 1 its back.
struct CurveEnd {
  SurfacePoint at;
  Vector3d outward;
};

CurveEnd endOf(const SurfaceCurve& c, bool back, double reachMm) {
  const std::size_t n = c.points.size();
  const auto point = [&](std::size_t i) { return c.points[back ? n - 1 - i : i]; };
  std::size_t inside = 1;
  while (inside + 1 < n && (point(inside).position - point(0).position).norm() < 0.5 * reachMm)
    ++inside;
  return {point(0), (point(0).position - point(inside).position).normalized()};
}

class EndPairs {
public:
  EndPairs(const PatchSurface& s, const std::vector<SurfaceCurve>& curves,
           const std::vector<double>& room, double minRoom, double reachMm)
      : s_(s), room_(room), minRoom_(minRoom), reachMm_(reachMm) {
    for (const SurfaceCurve& c : curves)
      for (const bool back : {false, true})
        ends_.push_back(endOf(c, back, reachMm));
    for (std::size_t e = 0; e < ends_.size(); ++e)
      nearest_.push_back(curves[e / 2].closed ? std::nullopt : nearestTo(e, curves));
  }

  // Returns the end that faces this one, if each is the other's nearest.
  std::optional<std::size_t> facing(std::size_t end) const {
    const std::optional<std::size_t> other = nearest_[end];
    return other && nearest_[*other] == end ? other : std::nullopt;
  }

private:
  std::optional<std::size_t> nearestTo(std::size_t e,
                                       const std::vector<SurfaceCurve>& curves) const {
    std::optional<std::size_t> best;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t o = 0; o < ends_.size(); ++o)
      if (const double d = (ends_[o].at.position - ends_[e].at.position).norm();
          o != e && !curves[o / 2].closed && d < minimum && face(ends_[e], ends_[o], d)) {
        minimum = d;
        best = o;
      }
    return best;
  }

  bool face(const CurveEnd& a, const CurveEnd& b, double distance) const {
    if (distance > reachMm_ || a.outward.dot(b.outward) > -kAligned)
      return false;
    if (distance < kTouchingMm)
      return true;
    const Vector3d to = (b.at.position - a.at.position) / distance,
                   middle = 0.5 * (a.at.position + b.at.position);
    if (a.outward.dot(to) < kAligned || b.outward.dot(to) > -kAligned)
      return false;
    const SurfacePoint on = s_.project(middle, a.at.triangle);
    return (on.position - middle).norm() < 0.25 * reachMm_ && s_.interpolate(room_, on) > minRoom_;
  }

  const PatchSurface& s_;
  const std::vector<double>& room_;
  const double minRoom_, reachMm_;
  std::vector<CurveEnd> ends_;
  std::vector<std::optional<std::size_t>> nearest_;
};

// Returns the ends at which the ring of this curve's front enters its curves; empty if it is none.
std::vector<std::size_t> ringFrom(std::size_t curve, const EndPairs& pairs) {
  std::vector<std::size_t> entries{2 * curve};
  while (true) {
    const std::optional<std::size_t> next = pairs.facing(entries.back() ^ 1U);
    if (!next)
      return {};
    if (*next == entries.front())
      return entries;
    entries.push_back(*next);
  }
}
} // namespace

std::vector<SurfaceCurve> joinRings(const PatchSurface& s, std::vector<SurfaceCurve> curves,
                                    const std::vector<double>& room, double minRoom,
                                    double reachMm) {
  const EndPairs pairs(s, curves, room, minRoom, reachMm);
  std::vector<SurfaceCurve> out;
  std::vector<char> isJoined(curves.size(), 0);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (isJoined[k])
      continue;
    SurfaceCurve ring;
    for (const std::size_t entry : ringFrom(k, pairs)) {
      SurfaceCurve& part = curves[entry / 2];
      isJoined[entry / 2] = 1;
      if (entry % 2 == 1)
        std::ranges::reverse(part.points);
      // A closed curve does not repeat points.
      if (!ring.points.empty() &&
          (part.points.front().position - ring.points.back().position).norm() < kTouchingMm)
        ring.points.pop_back();
      ring.points.insert(ring.points.end(), part.points.begin(), part.points.end());
      ring.closed = true;
    }
    if (ring.closed &&
        (ring.points.front().position - ring.points.back().position).norm() < kTouchingMm)
      ring.points.pop_back();
    out.push_back(ring.closed ? std::move(ring) : std::move(curves[k]));
  }
  return out;
}

} // namespace voluta::toolpath
