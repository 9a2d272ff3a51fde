#include "substrate/ground_distance.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/nearest_share.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace voluta::substrate {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kChordMm = 1e-3; // For meshes of rods without a closed form

Vector2d nearestOnSegment(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  return a + geometry::nearestShare(p, a, b) * (b - a);
}

// Profile and both ends in the half-plane (x, radius).
class RoundRod {
public:
  explicit RoundRod(platform::RodShape rod) : rod_(std::move(rod)), outline_(rod_.profile) {
    outline_.insert(outline_.begin(), Vector2d(outline_.front().x(), 0.0));
    outline_.emplace_back(outline_.back().x(), 0.0);
  }
  bool isInside(const Vector3d& p) const {
    return p.tail<2>().norm() < platform::radiusAt(rod_, p.x(), 0.0);
  }
  Vector3d nearest(const Vector3d& p) const {
    const Vector2d at(p.x(), p.tail<2>().norm());
    const Vector2d on = nearestInSection(at);
    const Vector2d direction =
        at.y() > 0.0 ? Vector2d(p.tail<2>() / at.y()) : Vector2d(Vector2d::UnitX());
    return {on.x(), on.y() * direction.x(), on.y() * direction.y()};
  }

private:
  Vector2d nearestInSection(const Vector2d& at) const {
    Vector2d best = outline_.front();
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < outline_.size(); ++i) {
      const Vector2d on = nearestOnSegment(outline_[i], outline_[i + 1], at);
      const double far = (on - at).squaredNorm();
      if (far < minimum) {
        minimum = far;
        best = on;
      }
    }
    return best;
  }

  platform::RodShape rod_;
  std::vector<Vector2d> outline_;
};

// A regular polygon extruded over [x0, x1].
class Prism {
public:
  Prism(double x0, double x1, double radius, int sides)
      : x0_(x0), x1_(x1), apothem_(radius * std::cos(base::kPi / sides)),
        halfSide_(radius * std::sin(base::kPi / sides)), side_(2.0 * base::kPi / sides) {}

  bool isInside(const Vector3d& p) const {
    return p.x() > x0_ && p.x() < x1_ && acrossSide(p).x() < apothem_;
  }
  Vector3d nearest(const Vector3d& p) const {
    const Vector2d at = acrossSide(p);
    const double x = std::clamp(p.x(), x0_, x1_);
    Vector2d on = at;
    if (at.x() > apothem_ || x == p.x())
      on = {apothem_, std::clamp(at.y(), -halfSide_, halfSide_)};
    const double angle = sideMiddle(p);
    return {x, std::cos(angle) * on.x() - std::sin(angle) * on.y(),
            std::sin(angle) * on.x() + std::cos(angle) * on.y()};
  }

private:
  // Returns the angle of the middle of the side that faces p.
  double sideMiddle(const Vector3d& p) const {
    return side_ * (std::floor(std::atan2(p.z(), p.y()) / side_) + 0.5);
  }
  // Returns the coordinates of p along that side's normal and along the side.
  Vector2d acrossSide(const Vector3d& p) const {
    const double angle = sideMiddle(p);
    return {std::cos(angle) * p.y() + std::sin(angle) * p.z(),
            -std::sin(angle) * p.y() + std::cos(angle) * p.z()};
  }

  double x0_, x1_, apothem_, halfSide_, side_;
};

class Body {
public:
  explicit Body(const geometry::TriangleMesh& mesh)
      : box_(geometry::bounds(mesh)), query_(std::make_shared<geometry::MeshQuery>(mesh)) {}

  Vector3d nearest(const Vector3d& p) const { return query_->closest(p).point; }
  // Casts a ray through the box's nearest side: winding numbers over long thin triangles take fifty
  // times as long.
  bool isInside(const Vector3d& p) const {
    if (!box_.contains(p))
      return false;
    Vector3d out = p;
    double minimum = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {box_.min()[axis], box_.max()[axis]})
        if (std::abs(side - p[axis]) < minimum) {
          minimum = std::abs(side - p[axis]);
          out = p;
          out[axis] = side + (side == box_.max()[axis] ? 1.0 : -1.0);
        }
    std::vector<geometry::MeshQuery::Hit> hits;
    query_->hits(p, out, hits);
    return hits.size() % 2 == 1;
  }

private:
  Eigen::AlignedBox3d box_;
  std::shared_ptr<const geometry::MeshQuery> query_;
};

template <typename Shape> GroundDistance distanceOf(Shape shape) {
  const auto kept = std::make_shared<const Shape>(std::move(shape));
  return {[kept](const Vector3d& p) { return kept->nearest(p); },
          [kept](const Vector3d& p) { return kept->isInside(p); }};
}

} // namespace

GroundDistance distanceFrom(const geometry::TriangleMesh& body) {
  return distanceOf(Body(body));
}

GroundDistance distanceFrom(const platform::RodShape& rod) {
  platform::checkRod(rod);
  if (rod.sides == 0)
    return distanceOf(RoundRod(rod));
  std::vector<GroundDistance> prisms;
  for (std::size_t i = 0; i + 1 < rod.profile.size(); ++i) {
    const Vector2d &a = rod.profile[i], &b = rod.profile[i + 1];
    if (a.x() == b.x())
      continue;
    if (a.y() != b.y()) // A frustum of a pyramid
      return distanceFrom(platform::meshOf(rod, kChordMm));
    prisms.push_back(distanceOf(Prism(a.x(), b.x(), a.y(), rod.sides)));
  }
  return nearestOf(std::move(prisms));
}

GroundDistance nearestOf(std::vector<GroundDistance> grounds) {
  base::require(!grounds.empty(), "a ground");
  if (grounds.size() == 1)
    return grounds.front();
  const auto all = std::make_shared<const std::vector<GroundDistance>>(std::move(grounds));
  return {[all](const Vector3d& p) {
            Vector3d best = Vector3d::Zero();
            double minimum = std::numeric_limits<double>::infinity();
            for (const GroundDistance& one : *all) {
              const Vector3d on = one.nearest(p);
              const double far = (on - p).squaredNorm();
              if (far < minimum) {
                minimum = far;
                best = on;
              }
            }
            return best;
          },
          [all](const Vector3d& p) {
            return std::any_of(all->begin(), all->end(),
                               [&](const GroundDistance& one) { return one.isInside(p); });
          }};
}

} // namespace voluta::substrate
