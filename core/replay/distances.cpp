#include "replay/distances.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::replay {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTolerance = 1e-4;

// Squared distance from (radius, z) to the trapezoid under the line (r0, z0) - (r1, z1).
double trapezoidSquared(const Vector2d& p, double r0, double z0, double r1, double z1) {
  const auto toSegment = [&](const Vector2d& a, const Vector2d& b) {
    const Vector2d ab = b - a;
    const double squared = ab.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
    return (p - a - t * ab).squaredNorm();
  };
  if (p.y() >= z0 && p.y() <= z1) {
    const double t = z1 > z0 ? (p.y() - z0) / (z1 - z0) : 0.0;
    if (p.x() <= r0 + t * (r1 - r0))
      return 0.0;
  }
  return std::min({toSegment({r0, z0}, {r1, z1}), toSegment({0.0, z0}, {r0, z0}),
                   toSegment({0.0, z1}, {r1, z1})});
}

struct PointDistance {
  const Vector3d& p;

  double operator()(const robot::Capsule& c) const {
    const Vector3d axis = c.p1 - c.p0;
    const double squared = axis.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - c.p0).dot(axis) / squared, 0.0, 1.0) : 0.0;
    return std::max(0.0, (p - c.p0 - t * axis).norm() - c.radius);
  }
  double operator()(const robot::Box& b) const {
    const Vector3d q = b.frame_T_box.inverse(Eigen::Isometry) * p;
    return (q.cwiseAbs() - b.half).cwiseMax(0.0).norm();
  }
  double operator()(const robot::Frustum& f) const {
    const double height = (f.p1 - f.p0).norm();
    const Vector3d axis = (f.p1 - f.p0) / height, r = p - f.p0;
    const double z = r.dot(axis);
    return std::sqrt(trapezoidSquared({(r - z * axis).norm(), z}, f.r0, 0.0, f.r1, height));
  }
  double operator()(const robot::Prism& s) const {
    bool inside = true;
    double nearest = std::numeric_limits<double>::infinity();
    const Vector2d q = p.head<2>();
    for (std::size_t i = 0; i < s.polygon.size(); ++i) {
      const Vector2d &a = s.polygon[i], &b = s.polygon[(i + 1) % s.polygon.size()];
      const Vector2d ab = b - a;
      inside = inside && ab.x() * (q - a).y() - ab.y() * (q - a).x() >= 0.0;
      const double t = std::clamp((q - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (q - a - t * ab).norm());
    }
    const double flat = inside ? 0.0 : nearest;
    const double up = std::max({0.0, p.z() - s.zMax, s.zMin - p.z()});
    return std::hypot(flat, up);
  }
};

// Returns the point of the solid's core farthest along `d`; the solid is the core grown by
// coreRadius.
struct Support {
  const Vector3d& d;

  Vector3d operator()(const robot::Capsule& c) const {
    return d.dot(c.p1 - c.p0) > 0.0 ? c.p1 : c.p0;
  }
  Vector3d operator()(const robot::Box& b) const {
    const Vector3d e = b.frame_T_box.linear().transpose() * d;
    Vector3d corner;
    for (int k = 0; k < 3; ++k)
      corner[k] = e[k] >= 0.0 ? b.half[k] : -b.half[k];
    return b.frame_T_box * corner;
  }
  Vector3d operator()(const robot::Frustum& f) const {
    const Vector3d axis = (f.p1 - f.p0).normalized();
    const Vector3d across = d - d.dot(axis) * axis;
    const double n = across.norm();
    const Vector3d rim = n > 1e-12 ? Vector3d(across / n) : Vector3d::Zero();
    const Vector3d a = f.p0 + f.r0 * rim, b = f.p1 + f.r1 * rim;
    return d.dot(b) > d.dot(a) ? b : a;
  }
  Vector3d operator()(const robot::Prism& s) const {
    const Vector2d* best = &s.polygon.front();
    for (const Vector2d& q : s.polygon)
      if (d.head<2>().dot(q) > d.head<2>().dot(*best))
        best = &q;
    return {best->x(), best->y(), d.z() >= 0.0 ? s.zMax : s.zMin};
  }
};

double coreRadius(const robot::Shape& shape) {
  const auto* capsule = std::get_if<robot::Capsule>(&shape);
  return capsule != nullptr ? capsule->radius : 0.0;
}

Vector3d supportOf(const robot::Shape& shape, const Eigen::Isometry3d& frame_T_shape,
                   const Vector3d& direction) {
  const Vector3d local = frame_T_shape.linear().transpose() * direction;
  return frame_T_shape * std::visit(Support{local}, shape);
}

// Up to four points; reduced to the smallest set whose convex hull contains the point nearest the
// origin.
struct Simplex {
  std::array<Vector3d, 4> w = {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(),
                               Vector3d::Zero()};
  int size = 0;

  Vector3d reduceToNearest() {
    Vector3d best = w[0];
    double minimum = std::numeric_limits<double>::infinity();
    Simplex kept;
    // Checks all faces: at most fifteen subsets of four points, each in closed form.
    for (int set = 1; set < (1 << size); ++set) {
      Simplex face;
      for (int k = 0; k < size; ++k)
        if (set & (1 << k))
          face.w[static_cast<std::size_t>(face.size++)] = w[static_cast<std::size_t>(k)];
      Vector3d v;
      if (!face.projection(v))
        continue;
      const double squared = v.squaredNorm();
      if (squared < minimum) {
        minimum = squared;
        best = v;
        kept = face;
      }
    }
    *this = kept;
    return best;
  }

private:
  // Computes the origin's projection onto the affine hull; returns false if it is outside the
  // simplex.
  bool projection(Vector3d& v) const {
    if (size == 1) {
      v = w[0];
      return true;
    }
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, size - 1);
    for (int k = 1; k < size; ++k)
      edges.col(k - 1) = w[static_cast<std::size_t>(k)] - w[0];
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram =
        edges.transpose() * edges;
    double determinant = 0.0, scale = 1.0;
    for (int k = 0; k < size - 1; ++k)
      scale *= gram(k, k);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> rhs = -edges.transpose() * w[0];
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> t(size - 1);
    if (size == 2) {
      determinant = gram(0, 0);
      t(0) = rhs(0) / determinant;
    } else if (size == 3) {
      determinant = gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(1, 0);
      t(0) = (rhs(0) * gram(1, 1) - rhs(1) * gram(0, 1)) / determinant;
      t(1) = (gram(0, 0) * rhs(1) - gram(1, 0) * rhs(0)) / determinant;
    } else {
      const Eigen::Matrix3d full = edges;
      determinant = std::pow(full.determinant(), 2);
      if (determinant > 1e-18 * scale)
        t = full.inverse() * -w[0];
    }
    if (!(determinant > 1e-18 * scale) || scale == 0.0)
      return false;
    double rest = 1.0;
    for (int k = 0; k < size - 1; ++k) {
      if (!(t(k) >= 0.0))
        return false;
      rest -= t(k);
    }
    if (rest < 0.0)
      return false;
    v = size == 4 ? Vector3d(Vector3d::Zero()) : Vector3d(w[0] + edges * t);
    return true;
  }
};

// Returns the distance of two convex solids given by their support functions; `v`: from a point of
// the second to a point of the first.
template <typename SupportA, typename SupportB>
double hullDistance(const SupportA& supportA, const SupportB& supportB, Vector3d v) {
  if (v.squaredNorm() < 1e-12)
    v = Vector3d::UnitX();
  Simplex simplex;
  double lower = 0.0;
  for (int round = 0; round < 100; ++round) {
    const Vector3d w = supportA(-v) - supportB(v);
    const double length = v.norm();
    // The whole difference set is beyond the plane through w perpendicular to v.
    if (simplex.size > 0) {
      lower = std::max(lower, v.dot(w) / length);
      if (length - lower <= kTolerance)
        return length;
    }
    for (int k = 0; k < simplex.size; ++k)
      if ((simplex.w[static_cast<std::size_t>(k)] - w).squaredNorm() < 1e-18)
        return length;
    simplex.w[static_cast<std::size_t>(simplex.size++)] = w;
    v = simplex.reduceToNearest();
    if (simplex.size == 4 || v.squaredNorm() < kTolerance * kTolerance)
      return 0.0;
  }
  return lower;
}

double coreDistance(const robot::Shape& a, const Eigen::Isometry3d& frame_T_a,
                    const robot::Shape& b, const Eigen::Isometry3d& frame_T_b) {
  return hullDistance([&](const Vector3d& d) { return supportOf(a, frame_T_a, d); },
                      [&](const Vector3d& d) { return supportOf(b, frame_T_b, d); },
                      frame_T_a * ballRound(a).centre - frame_T_b * ballRound(b).centre);
}

} // namespace

Ball ballRound(const robot::Shape& shape) {
  struct Visitor {
    Ball operator()(const robot::Capsule& c) const {
      return {0.5 * (c.p0 + c.p1), 0.5 * (c.p1 - c.p0).norm() + c.radius};
    }
    Ball operator()(const robot::Box& b) const {
      return {b.frame_T_box.translation(), b.half.norm()};
    }
    Ball operator()(const robot::Frustum& f) const {
      return {0.5 * (f.p0 + f.p1), std::hypot(0.5 * (f.p1 - f.p0).norm(), std::max(f.r0, f.r1))};
    }
    Ball operator()(const robot::Prism& s) const {
      Vector2d low = s.polygon.front(), high = low;
      for (const Vector2d& q : s.polygon) {
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
      }
      const Vector2d centre = 0.5 * (low + high);
      double flat = 0.0;
      for (const Vector2d& q : s.polygon)
        flat = std::max(flat, (q - centre).norm());
      return {{centre.x(), centre.y(), 0.5 * (s.zMin + s.zMax)},
              std::hypot(flat, 0.5 * (s.zMax - s.zMin))};
    }
  };
  return std::visit(Visitor{}, shape);
}

double distanceToPoint(const robot::Shape& shape, const Eigen::Vector3d& point) {
  return std::visit(PointDistance{point}, shape);
}

double segmentDistance(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                       const Eigen::Vector3d& q0, const Eigen::Vector3d& q1) {
  const Vector3d d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r);
  double s = 0.0, t = 0.0;
  if (a <= 0.0) {
    t = e > 0.0 ? std::clamp(f / e, 0.0, 1.0) : 0.0;
  } else if (e <= 0.0) {
    s = std::clamp(-c / a, 0.0, 1.0);
  } else {
    const double b = d1.dot(d2), denominator = a * e - b * b;
    if (denominator > 1e-14 * a * e)
      s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
    t = (b * s + f) / e;
    if (t < 0.0) {
      t = 0.0;
      s = std::clamp(-c / a, 0.0, 1.0);
    } else if (t > 1.0) {
      t = 1.0;
      s = std::clamp((b - c) / a, 0.0, 1.0);
    }
  }
  return (p0 + s * d1 - q0 - t * d2).norm();
}

double distanceBetween(const robot::Shape& a, const Eigen::Isometry3d& frame_T_a,
                       const robot::Shape& b, const Eigen::Isometry3d& frame_T_b) {
  const auto *ca = std::get_if<robot::Capsule>(&a), *cb = std::get_if<robot::Capsule>(&b);
  const double core = ca != nullptr && cb != nullptr
                          ? segmentDistance(frame_T_a * ca->p0, frame_T_a * ca->p1,
                                            frame_T_b * cb->p0, frame_T_b * cb->p1)
                          : coreDistance(a, frame_T_a, b, frame_T_b);
  return std::max(0.0, core - coreRadius(a) - coreRadius(b));
}

double distanceBetween(const FlatDisc& disc, const RoundedQuad& solid, double reachMm) {
  const auto ofDisc = [&](const Vector3d& d) -> Vector3d {
    const Vector3d across = d - d.dot(disc.normal) * disc.normal;
    const double n = across.norm();
    return n > 1e-12 ? Vector3d(disc.centre + disc.radius / n * across) : disc.centre;
  };
  const auto ofSolid = [&](const Vector3d& d) -> Vector3d {
    return *std::ranges::max_element(solid.corners, {},
                                     [&](const Vector3d& corner) { return corner.dot(d); });
  };
  const Vector3d apart = disc.centre - 0.25 * (solid.corners[0] + solid.corners[1] +
                                               solid.corners[2] + solid.corners[3]);
  return std::max(0.0, hullDistance(ofDisc, ofSolid, apart) - solid.radius + reachMm);
}

HeadSolid::HeadSolid(const process::HeadShape& shape) : sections_(shape.sections) {
  base::require(sections_.size() >= 2, "HeadSolid: two sections or more");
  double radius = 0.0;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    radius = std::max(radius, sections_[i].radiusMm);
    if (i == 0 || sections_[i].zMm <= sections_[i - 1].zMm)
      continue;
    const process::HeadSection &low = sections_[i - 1], &high = sections_[i];
    frusta_.push_back(
        robot::Frustum{{0, 0, low.zMm}, {0, 0, high.zMm}, low.radiusMm, high.radiusMm});
    const Vector2d outward =
        Vector2d(high.zMm - low.zMm, low.radiusMm - high.radiusMm).normalized();
    slants_.push_back({low, high, outward, outward.dot(Vector2d(low.radiusMm, low.zMm))});
  }
  const double low = sections_.front().zMm, high = sections_.back().zMm;
  ball_ = {{0, 0, 0.5 * (low + high)}, std::hypot(0.5 * (high - low), radius)};
}

double HeadSolid::distance(const Eigen::Vector3d& point) const {
  const Vector2d p(point.head<2>().norm(), point.z());
  double nearest = std::numeric_limits<double>::infinity();
  for (const Slant& side : slants_)
    nearest = std::min(nearest, trapezoidSquared(p, side.low.radiusMm, side.low.zMm,
                                                 side.high.radiusMm, side.high.zMm));
  return std::sqrt(nearest);
}

bool HeadSolid::within(double lateralSquared, double z, double reach) const {
  // Nearly all queried points are below the tip.
  if (z < sections_.front().zMm - reach || z > sections_.back().zMm + reach)
    return false;
  const Vector2d p(std::sqrt(lateralSquared), z);
  for (const Slant& side : slants_) {
    const double over = side.outward.dot(p) - side.at;
    if (over > reach || z < side.low.zMm - reach || z > side.high.zMm + reach)
      continue;
    if (over <= 0.0 && z >= side.low.zMm && z <= side.high.zMm)
      return true;
    if (trapezoidSquared(p, side.low.radiusMm, side.low.zMm, side.high.radiusMm, side.high.zMm) <=
        reach * reach)
      return true;
  }
  return false;
}

double HeadSolid::lowest(double tipZ, double axisZ) const {
  const double across = std::sqrt(std::max(0.0, 1.0 - axisZ * axisZ));
  double low = std::numeric_limits<double>::infinity();
  for (const process::HeadSection& s : sections_)
    low = std::min(low, tipZ + s.zMm * axisZ - s.radiusMm * across);
  return low;
}

Eigen::AlignedBox3d HeadSolid::boxRound(const Vector3d& tip, const Vector3d& axis) const {
  const Vector3d across = (1.0 - axis.array().square()).max(0.0).sqrt().matrix();
  Eigen::AlignedBox3d box;
  for (const process::HeadSection& s : sections_) {
    const Vector3d centre = tip + s.zMm * axis;
    box.extend(Vector3d(centre - s.radiusMm * across));
    box.extend(Vector3d(centre + s.radiusMm * across));
  }
  return box;
}

double HeadSolid::reach() const {
  double reach = 0.0;
  for (const process::HeadSection& s : sections_)
    reach = std::max(reach, std::hypot(s.zMm, s.radiusMm));
  return reach;
}

} // namespace voluta::replay
