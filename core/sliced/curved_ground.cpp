#include "sliced/curved_ground.h"

#include <cmath>

namespace voluta::sliced {

using Eigen::Vector2d, Eigen::Vector3d;

double CurvedGround::angleAt(const Vector3d& level) const {
  if (!isCurved())
    return 0.0;
  const double distance =
      shape == GroundShape::Cylinder ? std::abs(level.y()) : level.head<2>().norm();
  return distance / std::abs(keepsAngles ? radiusMm : radiusMm + level.z());
}

CurvedGround::Mapped CurvedGround::map(const Vector3d& level) const {
  Mapped mapped;
  mapped.position = level;
  if (!isCurved())
    return mapped;
  const bool isSphere = shape == GroundShape::Sphere;
  const Vector2d out = level.head<2>();
  const double distance = isSphere ? out.norm() : level.y();
  mapped.axis = !isSphere          ? Vector2d(Vector2d::UnitY())
                : distance > 1e-12 ? Vector2d(out / distance)
                                   : Vector2d(Vector2d::UnitX());
  const double r = radiusMm + level.z();
  const double angle = distance / (keepsAngles ? radiusMm : r);
  const double reach = r * std::sin(angle);
  mapped.position.head<2>() = reach * mapped.axis;
  if (!isSphere)
    mapped.position.x() = level.x();
  mapped.position.z() = r * std::cos(angle) - radiusMm;
  const Vector3d hinge(-mapped.axis.y(), mapped.axis.x(), 0.0);
  mapped.rotation = Eigen::AngleAxisd(angle, hinge).toRotationMatrix();
  mapped.along = keepsAngles ? r / radiusMm : 1.0;
  if (isSphere)
    mapped.across = distance > 1e-9 ? reach / distance : mapped.along;
  return mapped;
}

double hatchFactor(const CurvedGround::Mapped& mapped, const Vector2d& direction) {
  const Vector2d t = direction.normalized();
  const double onAxis = t.dot(mapped.axis),
               beside = std::sqrt(std::max(0.0, 1.0 - onAxis * onAxis));
  return mapped.along * mapped.across / std::hypot(mapped.along * onAxis, mapped.across * beside);
}

} // namespace voluta::sliced
