// Simple solids of which links, heads, platforms and obstacles consist. mm, in the body's frame.
#pragma once

#include "base/text.h"

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

namespace voluta::robot {

// All points within `radius` of the segment p0 p1 (a sphere if p0 == p1).
struct Capsule {
  Eigen::Vector3d p0, p1;
  double radius;
};
// Half extents along the axes of `frame_T_box`.
struct Box {
  Eigen::Isometry3d frame_T_box;
  Eigen::Vector3d half;
};
// Solid of revolution about p0 p1: radius r0 at p0, r1 at p1 (flat ends; a cylinder if equal).
struct Frustum {
  Eigen::Vector3d p0, p1;
  double r0, r1;
};
// A convex polygon (counter-clockwise, in the frame's xy plane) from zMin to zMax.
struct Prism {
  std::vector<Eigen::Vector2d> polygon;
  double zMin, zMax;
};
using Shape = std::variant<Capsule, Box, Frustum, Prism>;

enum class BodyRole { Link, Holder, Head, Platform, Obstacle };
inline constexpr int kBodyRoleCount = 5;

// A rigid body: shapes in the frame it is fixed to.
struct Body {
  std::string name;
  BodyRole role = BodyRole::Obstacle;
  int frame = 0; // index of a cell frame (robot/cell.h)
  std::vector<Shape> shapes;
};

// Returns the name shown to users: for the cell's own bodies their role, for others the name from
// the file.
base::Value nameOf(const Body& body);

} // namespace voluta::robot
