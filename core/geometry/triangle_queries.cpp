#include "geometry/triangle_queries.h"
#include "geometry/nearest_share.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

// Returns the exact sign of the cross product of p and q, both relative to the segment's line; if
// it is zero, the sign after shifting the line by (e, e^2) for a vanishing e > 0. Antisymmetric in
// p, q.
int sideOf(const Vector3d& p, const Vector3d& q) {
  const double left = p.x() * q.y(), right = p.y() * q.x();
  if (left != right) // rounding is monotone
    return left > right ? 1 : -1;
  const double leftRest = std::fma(p.x(), q.y(), -left);
  const double rightRest = std::fma(p.y(), q.x(), -right);
  if (leftRest != rightRest)
    return leftRest > rightRest ? 1 : -1;
  if (p.y() != q.y())
    return p.y() > q.y() ? 1 : -1;
  if (p.x() != q.x())
    return q.x() > p.x() ? 1 : -1;
  return 0;
}

} // namespace

Vector3d closestPointOnTriangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                                const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
    return a;
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
    return b;
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
    return c;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    return a + ratio(d1, d1 - d3) * ab;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    return a + ratio(d2, d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
    return b + ratio(d4 - d3, (d4 - d3) + (d5 - d6)) * (c - b);
  const double whole = va + vb + vc;
  return a + ratio(vb, whole) * ab + ratio(vc, whole) * ac;
}

double distanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  return (p - a - nearestShare(p, a, b) * (b - a)).norm();
}

double solidAngle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d pa = a - p, pb = b - p, pc = c - p;
  const double la = pa.norm(), lb = pb.norm(), lc = pc.norm();
  const double volume = pa.dot(pb.cross(pc));
  const double rest = la * lb * lc + pa.dot(pb) * lc + pb.dot(pc) * la + pc.dot(pa) * lb;
  return 2.0 * std::atan2(volume, rest);
}

SegmentTest::SegmentTest(const Vector3d& from, const Vector3d& to) : from_(from), step_(to - from) {
  step_.cwiseAbs().maxCoeff(&kz_);
  kx_ = (kz_ + 1) % 3;
  ky_ = (kz_ + 2) % 3;
  point_ = step_[kz_] == 0.0;
  if (!point_) {
    sx_ = step_[kx_] / step_[kz_];
    sy_ = step_[ky_] / step_[kz_];
    sz_ = 1.0 / step_[kz_];
  }
  inverse_ = step_.cwiseInverse();
  pad_ = 1e-12 * std::max(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
}

Vector3d SegmentTest::shear(const Vector3d& p) const {
  const double x = p[kx_] - from_[kx_], y = p[ky_] - from_[ky_], z = p[kz_] - from_[kz_];
  return {x - sx_ * z, y - sy_ * z, sz_ * z};
}

std::optional<double> SegmentTest::cross(const Vector3d& a, const Vector3d& b,
                                         const Vector3d& c) const {
  if (point_)
    return std::nullopt;
  // A corner's sheared position depends on the corner only, and sides are exact in it: triangles
  // that share an edge or a vertex give consistent results.
  const Vector3d sa = shear(a), sb = shear(b), sc = shear(c);
  const int sideA = sideOf(sb, sc), sideB = sideOf(sc, sa);
  if (sideA == 0 || sideA != sideB || sideB != sideOf(sa, sb))
    return std::nullopt;
  const double u = sb.x() * sc.y() - sb.y() * sc.x(), v = sc.x() * sa.y() - sc.y() * sa.x(),
               w = sa.x() * sb.y() - sa.y() * sb.x(), sum = u + v + w;
  const auto [low, high] = std::minmax({sa.z(), sb.z(), sc.z()});
  const double t =
      sum == 0.0 ? low : std::clamp((u * sa.z() + v * sb.z() + w * sc.z()) / sum, low, high);
  if (!(t >= 0.0 && t <= 1.0))
    return std::nullopt;
  return t;
}

bool SegmentTest::mayTouch(const Vector3d& low, const Vector3d& high, double tMax) const {
  double enter = 0.0, leave = tMax;
  for (int k = 0; k < 3; ++k) {
    const double pad = pad_ + 1e-12 * std::max(std::abs(low[k]), std::abs(high[k]));
    const double near = low[k] - pad - from_[k], far = high[k] + pad - from_[k];
    if (step_[k] == 0.0) {
      if (near > 0.0 || far < 0.0)
        return false;
      continue;
    }
    const double t0 = near * inverse_[k], t1 = far * inverse_[k];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave * (1.0 + 1e-12) + 1e-15;
}

} // namespace voluta::geometry
