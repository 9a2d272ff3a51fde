// Replay's own distances between simple convex solids and points [mm].
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
// Returns a ball that contains the shape, in the shape's frame.
Ball ballRound(const robot::Shape& shape);

// Returns the exact distance from a point to the solid, both in the shape's frame; 0 inside.
double distanceToPoint(const robot::Shape& shape, const Eigen::Vector3d& point);

// Returns the distance between segments p0 p1 and q0 q1 (Ericson, Real-Time Collision Detection,
// 5.1.9).
double segmentDistance(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                       const Eigen::Vector3d& q0, const Eigen::Vector3d& q1);

// Returns the distance between two solids placed in a common frame; 0 if they intersect. Two
// capsules are computed in closed form, all else by Gilbert, Johnson and Keerthi's algorithm on
// support functions (IEEE J. Robotics and Automation 4(2), 1988). The result exceeds the true
// distance by at most 1e-4 mm.
double distanceBetween(const robot::Shape& a, const Eigen::Isometry3d& frame_T_a,
                       const robot::Shape& b, const Eigen::Isometry3d& frame_T_b);

struct FlatDisc {
  Eigen::Vector3d centre, normal; // unit vector
  double radius;
};
// The convex hull of four corners, grown by a radius.
struct RoundedQuad {
  std::array<Eigen::Vector3d, 4> corners;
  double radius;
};
// Returns the distance between the disc and the solid with its radius reduced by `reachMm`; 0 if
// they intersect. Exact to 1e-4 mm.
double distanceBetween(const FlatDisc& disc, const RoundedQuad& solid, double reachMm = 0.0);

// A head: frusta about the z axis, which points from the tip up into the head.
class HeadSolid {
public:
  explicit HeadSolid(const process::HeadShape& shape);

  // Returns the exact distance from a point (head's frame) to the solid, computed in the (radius,
  // z) half plane; 0 inside.
  double distance(const Eigen::Vector3d& point) const;
  // Returns distance(point) <= reach, faster, for a point given by its squared distance from the
  // axis and its position along it.
  bool within(double lateralSquared, double z, double reach) const;
  // Returns the height of its lowest point over the plane z = 0 of a frame in which the tip is at
  // tipZ and the axis makes the angle with cosine `axisZ` with z.
  double lowest(double tipZ, double axisZ) const;
  const std::vector<robot::Shape>& frusta() const { return frusta_; }
  Ball ball() const { return ball_; }
  // Returns a box that contains it, in a frame with this tip and axis (unit).
  Eigen::AlignedBox3d boxRound(const Eigen::Vector3d& tip, const Eigen::Vector3d& axis) const;
  // Returns the largest distance of its points from the tip.
  double reach() const;

private:
  // A frustum in the (radius, z) half plane: it is on one side of a line, outward.p <= at.
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
