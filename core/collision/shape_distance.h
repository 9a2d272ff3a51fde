// Exact signed distances from points to the solids of robot/body.h, and the distances between
// solids that reduce to them.
#pragma once

#include "robot/body.h"

#include <Eigen/Geometry>
#include <variant>
#include <vector>

namespace voluta::collision {

// Solids placed in another frame, with precomputed data for queries. signedDistance(point): mm,
// negative inside, exact inside and outside. Points and solid in one frame.
class PlacedCapsule {
public:
  PlacedCapsule(const robot::Capsule& shape, const Eigen::Isometry3d& frame_T_shape);
  double signedDistance(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d r = point - p0_;
    const double t = inverseSquaredLength_ > 0.0
                         ? std::min(1.0, std::max(0.0, r.dot(axis_) * inverseSquaredLength_))
                         : 0.0;
    return (r - t * axis_).norm() - radius_;
  }
  const Eigen::Vector3d& p0() const { return p0_; }
  Eigen::Vector3d p1() const { return p0_ + axis_; }
  double radius() const { return radius_; }

private:
  Eigen::Vector3d p0_, axis_; // axis_: p1 - p0
  double inverseSquaredLength_, radius_;
};

class PlacedBox {
public:
  PlacedBox(const robot::Box& shape, const Eigen::Isometry3d& frame_T_shape);
  double signedDistance(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d q =
        (box_R_frame_ * (point - centre_)).cwiseAbs() - half_; // > 0 outside that pair of faces
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  }
  const Eigen::Vector3d& centre() const { return centre_; }
  double outerRadius() const { return half_.norm(); }

private:
  Eigen::Matrix3d box_R_frame_;
  Eigen::Vector3d centre_, half_;
};

// A frustum in the half plane (rho, z) about its axis, z from its first end: a quadrilateral with
// its left side on the axis.
class FrustumProfile {
public:
  FrustumProfile(double length, double r0, double r1);
  double signedDistance(double rho, double z) const;
  double length() const { return length_; }
  double r0() const { return r0_; }
  double r1() const { return r1_; }

private:
  double length_, r0_, r1_;
  double sideX_, inverseSideSquared_, normalX_, normalZ_; // of the slanted side
};

class PlacedFrustum {
public:
  PlacedFrustum(const robot::Frustum& shape, const Eigen::Isometry3d& frame_T_shape);
  double signedDistance(const Eigen::Vector3d& point) const;
  const Eigen::Vector3d& centre() const { return centre_; }
  double outerRadius() const { return outerRadius_; }

private:
  FrustumProfile profile_;
  Eigen::Vector3d p0_, axis_, centre_; // axis_: unit
  double outerRadius_;
};

struct Disc {
  Eigen::Vector3d centre, normal; // unit
  double radius = 0.0;
};

// Frusta about the z axis of their frame, e.g. those of a head, as one solid.
class Revolved {
public:
  // Precondition: both ends of each on the axis.
  explicit Revolved(const std::vector<robot::Frustum>& frusta);
  // Returns the minimum of the frusta's distances; negative inside any of them. rho: distance of
  // the point from the axis.
  double signedDistance(double rho, double z) const;
  // Returns its flat first end as placed, grown by a margin (negative: shrunk). `normal` points
  // into the solid.
  Disc underside(const Eigen::Isometry3d& frame_T_solid, double marginMm) const;
  // Returns the height of its lowest point above the origin of a frame in which its axis is `axis`
  // (unit).
  double lowest(const Eigen::Vector3d& axis) const;

private:
  struct Piece {
    double from, up; // along the axis: its first end, and 1 or -1
    FrustumProfile profile;
  };
  std::vector<Piece> pieces_;
};

class PlacedPrism {
public:
  PlacedPrism(const robot::Prism& shape, const Eigen::Isometry3d& frame_T_shape);
  double signedDistance(const Eigen::Vector3d& point) const;
  const Eigen::Vector3d& centre() const { return centre_; }
  double outerRadius() const { return outerRadius_; }

private:
  Eigen::Isometry3d shape_T_frame_;
  Eigen::Vector3d centre_; // in the frame
  std::vector<Eigen::Vector2d> polygon_;
  double zMin_, zMax_, outerRadius_;
};

using PlacedShape = std::variant<PlacedCapsule, PlacedBox, PlacedFrustum, PlacedPrism>;

// Preconditions: radii, half extents and lengths >= 0, zMin <= zMax, polygon of >= 3 points.
PlacedShape place(const robot::Shape& shape, const Eigen::Isometry3d& frame_T_shape);

// mm, negative inside.
double signedDistance(const PlacedShape& shape, const Eigen::Vector3d& point);
// Point in the shape's own frame.
double signedDistance(const robot::Shape& shape, const Eigen::Vector3d& point);

// A sphere that contains the shape.
struct Ball {
  Eigen::Vector3d centre;
  double radius;
};
Ball boundingBall(const PlacedShape& shape);

// Returns the maximum extent of the shape along a unit direction of its own frame [mm].
double support(const robot::Shape& shape, const Eigen::Vector3d& direction);

// Distance of two segments p0 p1 and q0 q1 (either may be a point). mm. Source: Ericson, Real-Time
// Collision Detection, 5.1.9.
double segmentDistance(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                       const Eigen::Vector3d& q0, const Eigen::Vector3d& q1);

// Returns the distance of a capsule to a convex solid, in one frame: the minimum signed distance
// along its axis (a convex function of the position on it) minus its radius. Negative: they
// overlap, by at least that amount. mm, to 1e-4 mm. The search ends early, with a value on the
// right side of it, once the result is known to be above `enough` (pass infinity for the distance
// itself).
double capsuleDistance(const robot::Capsule& capsule, const PlacedShape& convex, double enough);

} // namespace voluta::collision
