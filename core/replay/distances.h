// Replay's own distances between simple convex solids and points. mm.
#pragma once

#include "process/process.h"
#include "robot/body.h"

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace voluta::replay {

struct Ball {
  Eigen::Vector3d centre;
  double radius;
};
// A ball that holds the shape, in the shape's frame.
Ball ballRound(const robot::Shape& shape);

// From a point to the solid, both in the shape's frame; 0 inside. Exact.
double distanceToPoint(const robot::Shape& shape, const Eigen::Vector3d& point);

// Between segments p0 p1 and q0 q1 (Ericson, Real-Time Collision Detection, 5.1.9).
double segmentDistance(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                       const Eigen::Vector3d& q0, const Eigen::Vector3d& q1);

// Between two solids placed in a common frame; 0 when they meet. Two capsules in closed form,
// all else by Gilbert, Johnson and Keerthi's algorithm on support functions (IEEE J. Robotics and
// Automation 4(2), 1988) to 1e-4 mm; it never claims more than the true distance by more.
double distanceBetween(const robot::Shape& a, const Eigen::Isometry3d& frame_T_a,
                       const robot::Shape& b, const Eigen::Isometry3d& frame_T_b);

struct FlatDisc {
  Eigen::Vector3d centre, normal; // unit
  double radius;
};
// The hull of four corners, grown by a radius.
struct RoundedQuad {
  std::array<Eigen::Vector3d, 4> corners;
  double radius;
};
// Between the disc and the solid less `reachMm` of its radius; 0 where they meet. Exact to 1e-4 mm.
double distanceBetween(const FlatDisc& disc, const RoundedQuad& solid, double reachMm = 0.0);

// A head: frusta about the z axis, which runs from the tip up into it.
class HeadSolid {
public:
  explicit HeadSolid(const process::HeadShape& shape);

  // From a point (head's frame) to the solid; 0 inside. Exact: in the (radius, z) half plane.
  double distance(const Eigen::Vector3d& point) const;
  // distance(point) <= reach, quicker, for a point so far along the axis and aside of it.
  bool within(double asideSquared, double z, double reach) const;
  // Its lowest point over the plane z = 0 of a frame in which the tip is at tipZ and the axis makes
  // the angle with cosine `axisZ` to z.
  double lowest(double tipZ, double axisZ) const;
  const std::vector<robot::Shape>& frusta() const { return frusta_; }
  Ball ball() const { return ball_; }
  // A box that holds it, in a frame in which tip and axis (unit) are these.
  Eigen::AlignedBox3d boxRound(const Eigen::Vector3d& tip, const Eigen::Vector3d& axis) const;
  // Of its points from its tip, at most.
  double reach() const;

private:
  // Of a frustum, in the (radius, z) half plane: it lies on one side of a line, outward.p <= at.
  struct Slant {
    process::HeadSection low, high;
    Eigen::Vector2d outward;
    double at;
  };
  std::vector<process::HeadSection> sections_;
  std::vector<robot::Shape> frusta_;
  std::vector<Slant> slants_;
  Ball ball_;
};

} // namespace voluta::replay
