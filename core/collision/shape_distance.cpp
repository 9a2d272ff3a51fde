#include "collision/shape_distance.h"

#include "base/error.h"
#include "geometry/golden_section.h"
#include "geometry/nearest_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::collision {

using base::require;
using Eigen::Vector2d;
using Eigen::Vector3d;

PlacedCapsule::PlacedCapsule(const robot::Capsule& shape, const Eigen::Isometry3d& frame_T_shape)
    : p0_(frame_T_shape * shape.p0), axis_(frame_T_shape.linear() * (shape.p1 - shape.p0)),
      radius_(shape.radius) {
  require(shape.radius >= 0.0, "capsule radius >= 0");
  const double squared = axis_.squaredNorm();
  inverseSquaredLength_ = squared > 0.0 ? 1.0 / squared : 0.0;
}

PlacedBox::PlacedBox(const robot::Box& shape, const Eigen::Isometry3d& frame_T_shape)
    : half_(shape.half) {
  require(shape.half.minCoeff() >= 0.0, "box half extents >= 0");
  const Eigen::Isometry3d frame_T_box = frame_T_shape * shape.frame_T_box;
  box_R_frame_ = frame_T_box.linear().transpose();
  centre_ = frame_T_box.translation();
}

FrustumProfile::FrustumProfile(double length, double r0, double r1)
    : length_(length), r0_(r0), r1_(r1), sideX_(r1 - r0) {
  require(length >= 0.0 && r0 >= 0.0 && r1 >= 0.0, "frustum length and radii >= 0");
  const double squared = sideX_ * sideX_ + length_ * length_;
  inverseSideSquared_ = squared > 0.0 ? 1.0 / squared : 0.0;
  const double side = std::sqrt(squared);
  normalX_ = side > 0.0 ? length_ / side : 0.0;
  normalZ_ = side > 0.0 ? -sideX_ / side : 0.0;
}

double FrustumProfile::signedDistance(double rho, double z) const {
  const double toSide = (rho - r0_) * normalX_ + z * normalZ_; // > 0 outside the slant
  const double toCaps = std::max(-z, z - length_);
  if (length_ > 0.0 && toSide <= 0.0 && toCaps <= 0.0)
    return std::max(toSide, toCaps); // inside: the nearest of the planes
  // Directly above or below a cap; otherwise the slant or one of its ends is nearest.
  if (z <= 0.0 && rho <= r0_)
    return -z;
  if (z >= length_ && rho <= r1_)
    return z - length_;
  const double t = std::clamp(((rho - r0_) * sideX_ + z * length_) * inverseSideSquared_, 0.0, 1.0);
  const double x = rho - r0_ - t * sideX_, y = z - t * length_;
  return std::sqrt(x * x + y * y);
}

PlacedFrustum::PlacedFrustum(const robot::Frustum& shape, const Eigen::Isometry3d& frame_T_shape)
    : profile_((shape.p1 - shape.p0).norm(), shape.r0, shape.r1), p0_(frame_T_shape * shape.p0) {
  const Vector3d along = frame_T_shape.linear() * (shape.p1 - shape.p0);
  axis_ =
      profile_.length() > 0.0 ? Vector3d(along / profile_.length()) : Vector3d(Vector3d::UnitZ());
  centre_ = p0_ + 0.5 * along;
  outerRadius_ = std::hypot(0.5 * profile_.length(), std::max(shape.r0, shape.r1));
}

double PlacedFrustum::signedDistance(const Vector3d& point) const {
  const Vector3d r = point - p0_;
  const double z = r.dot(axis_);
  return profile_.signedDistance(std::sqrt(std::max(0.0, r.squaredNorm() - z * z)), z);
}

Revolved::Revolved(const std::vector<robot::Frustum>& frusta) {
  for (const robot::Frustum& f : frusta) {
    require(f.p0.head<2>().isZero(0.0) && f.p1.head<2>().isZero(0.0), "frusta about the z axis");
    const double delta = f.p1.z() - f.p0.z();
    pieces_.push_back({f.p0.z(), delta < 0.0 ? -1.0 : 1.0, {std::abs(delta), f.r0, f.r1}});
  }
}

double Revolved::signedDistance(double rho, double z) const {
  double minimum = std::numeric_limits<double>::infinity();
  for (const Piece& p : pieces_)
    minimum = std::min(minimum, p.profile.signedDistance(rho, p.up * (z - p.from)));
  return minimum;
}

Disc Revolved::underside(const Eigen::Isometry3d& frame_T_solid, double marginMm) const {
  require(!pieces_.empty(), "a solid with a flat end");
  const Piece& first = pieces_.front();
  return {frame_T_solid * Vector3d(0.0, 0.0, first.from - first.up * marginMm),
          frame_T_solid.linear() * Vector3d(0.0, 0.0, first.up),
          std::max(0.0, first.profile.r0() + marginMm)};
}

double Revolved::lowest(const Vector3d& axis) const {
  const double across = std::sqrt(std::max(0.0, 1.0 - axis.z() * axis.z()));
  double lowest = std::numeric_limits<double>::infinity();
  for (const Piece& p : pieces_) {
    const double to = p.from + p.up * p.profile.length();
    lowest = std::min({lowest, axis.z() * p.from - across * p.profile.r0(),
                       axis.z() * to - across * p.profile.r1()});
  }
  return lowest;
}

PlacedPrism::PlacedPrism(const robot::Prism& shape, const Eigen::Isometry3d& frame_T_shape)
    : shape_T_frame_(frame_T_shape.inverse()), polygon_(shape.polygon), zMin_(shape.zMin),
      zMax_(shape.zMax) {
  require(polygon_.size() >= 3, "prism polygon of at least 3 points");
  require(zMin_ <= zMax_, "prism zMin <= zMax");
  Vector2d low = polygon_.front(), high = low;
  for (const Vector2d& p : polygon_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector2d middle = 0.5 * (low + high);
  double radius = 0.0;
  for (const Vector2d& p : polygon_)
    radius = std::max(radius, (p - middle).norm());
  centre_ = frame_T_shape * Vector3d(middle.x(), middle.y(), 0.5 * (zMin_ + zMax_));
  outerRadius_ = std::hypot(radius, 0.5 * (zMax_ - zMin_));
}

double PlacedPrism::signedDistance(const Vector3d& point) const {
  const Vector3d p = shape_T_frame_ * point;
  const Vector2d q = p.head<2>();
  double squared = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0, j = polygon_.size() - 1; i < polygon_.size(); j = i++) {
    const Vector2d &a = polygon_[j], &b = polygon_[i];
    const Vector2d edge = b - a, r = q - a;
    const double t = geometry::nearestShare(q, a, b);
    squared = std::min(squared, (r - t * edge).squaredNorm());
    if ((a.y() > q.y()) != (b.y() > q.y()) &&
        q.x() < a.x() + (q.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  const double flat = inside ? -std::sqrt(squared) : std::sqrt(squared);
  const double up = std::max(zMin_ - p.z(), p.z() - zMax_);
  return std::hypot(std::max(flat, 0.0), std::max(up, 0.0)) + std::min(std::max(flat, up), 0.0);
}

PlacedShape place(const robot::Shape& shape, const Eigen::Isometry3d& frame_T_shape) {
  return std::visit(
      [&](const auto& s) -> PlacedShape {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, robot::Capsule>)
          return PlacedCapsule(s, frame_T_shape);
        else if constexpr (std::is_same_v<S, robot::Box>)
          return PlacedBox(s, frame_T_shape);
        else if constexpr (std::is_same_v<S, robot::Frustum>)
          return PlacedFrustum(s, frame_T_shape);
        else
          return PlacedPrism(s, frame_T_shape);
      },
      shape);
}

double signedDistance(const PlacedShape& shape, const Vector3d& point) {
  return std::visit([&](const auto& s) { return s.signedDistance(point); }, shape);
}

double signedDistance(const robot::Shape& shape, const Vector3d& point) {
  return signedDistance(place(shape, Eigen::Isometry3d::Identity()), point);
}

Ball boundingBall(const PlacedShape& shape) {
  return std::visit(
      [](const auto& s) -> Ball {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, PlacedCapsule>)
          return {0.5 * (s.p0() + s.p1()), 0.5 * (s.p1() - s.p0()).norm() + s.radius()};
        else
          return {s.centre(), s.outerRadius()};
      },
      shape);
}

double support(const robot::Shape& shape, const Vector3d& d) {
  if (const auto* c = std::get_if<robot::Capsule>(&shape))
    return std::max(c->p0.dot(d), c->p1.dot(d)) + c->radius;
  if (const auto* b = std::get_if<robot::Box>(&shape))
    return b->frame_T_box.translation().dot(d) +
           (b->frame_T_box.linear().transpose() * d).cwiseAbs().dot(b->half);
  if (const auto* f = std::get_if<robot::Frustum>(&shape)) {
    const Vector3d u = (f->p1 - f->p0).normalized();
    const double across = std::sqrt(std::max(0.0, 1.0 - std::pow(u.dot(d), 2)));
    return std::max(f->p0.dot(d) + f->r0 * across, f->p1.dot(d) + f->r1 * across);
  }
  const auto& p = std::get<robot::Prism>(shape);
  double flat = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& corner : p.polygon)
    flat = std::max(flat, corner.dot(d.head<2>()));
  return flat + std::max(p.zMin * d.z(), p.zMax * d.z());
}

double segmentDistance(const Vector3d& p0, const Vector3d& p1, const Vector3d& q0,
                       const Vector3d& q1) {
  const Vector3d u = p1 - p0, v = q1 - q0, r = p0 - q0;
  const double a = u.squaredNorm(), e = v.squaredNorm(), f = v.dot(r);
  double s = 0.0, t = 0.0;
  if (a <= 0.0) {
    t = e > 0.0 ? std::clamp(f / e, 0.0, 1.0) : 0.0;
  } else {
    const double c = u.dot(r);
    if (e <= 0.0) {
      s = std::clamp(-c / a, 0.0, 1.0);
    } else {
      const double b = u.dot(v), denominator = a * e - b * b;
      s = denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
      t = (b * s + f) / e;
      if (t < 0.0) {
        t = 0.0;
        s = std::clamp(-c / a, 0.0, 1.0);
      } else if (t > 1.0) {
        t = 1.0;
        s = std::clamp((b - c) / a, 0.0, 1.0);
      }
    }
  }
  return (r + s * u - t * v).norm();
}

double capsuleDistance(const robot::Capsule& capsule, const PlacedShape& convex, double enough) {
  if (const auto* other = std::get_if<PlacedCapsule>(&convex))
    return segmentDistance(capsule.p0, capsule.p1, other->p0(), other->p1()) - capsule.radius -
           other->radius();
  return std::visit(
      [&](const auto& s) {
        const Vector3d axis = capsule.p1 - capsule.p0;
        const double length = axis.norm(), radius = capsule.radius;
        const auto at = [&](double t) { return s.signedDistance(capsule.p0 + t * axis); };
        double atLow = at(0.0), atHigh = at(1.0);
        double best = std::min(atLow, atHigh);
        // A signed distance changes by at most the distance travelled, so the ends bound the
        // interior.
        if (length < 1e-6 || 0.5 * (atLow + atHigh - length) - radius > enough)
          return best - radius;
        constexpr double kPlaceMm = 1e-4, kExactMm = 1e-6;
        geometry::GoldenSection search(at, 0.0, 1.0);
        // Two probes that differ by less than rounding still bracket the minimum of a convex
        // function; only the value has to be exact, not its position.
        while ((search.high - search.low) * length > kPlaceMm) {
          const double f1 = search.atA, f2 = search.atB;
          best = std::min({best, f1, f2});
          // The function is above the extended neighbouring chords: above that between the probes
          // on the far side of the lower one, above the outer chords between the probes.
          const double left = search.a - search.low, between = search.b - search.a,
                       right = search.high - search.b;
          const double beyond =
              f1 < f2 ? f1 - (f2 - f1) * left / between : f2 - (f1 - f2) * right / between;
          const double within =
              std::max(f1 + (f1 - atLow) * between / left, f2 + (f2 - atHigh) * between / right);
          const double minimum = std::min({best, beyond, within});
          if (minimum - radius > enough)
            return minimum - radius;
          if (best - minimum <= kExactMm)
            break;
          if (search.dropsUpper())
            atHigh = f2;
          else
            atLow = f1;
          search.step();
        }
        return std::min({best, search.atA, search.atB}) - radius;
      },
      convex);
}

} // namespace voluta::collision
