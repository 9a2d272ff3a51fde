// Visual solids lofted along a line: each section is the convex hull of discs (one disc: a circle;
// two: a bar with round ends; four: a rectangle with round corners). Flat ends, all edges rounded.
// Not used by any check: collisions are checked with robot::Shape.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::robot {

struct LoftDisc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

// Discs counter-clockwise around the loft's z, none inside another.
struct LoftSection {
  double at = 0.0; // Position along the loft's z
  std::vector<LoftDisc> discs;
};

// [mm]. At least two sections with the same number of discs, each not lower than the previous one.
struct Loft {
  Eigen::Isometry3d frame_T_loft = Eigen::Isometry3d::Identity();
  std::vector<LoftSection> sections;
  double roundMm = 0.0; // Radius of its edges; smaller where an edge has too little room
};

// Return a disc and a rectangle as a section. roundMm: radius of the rectangle's corners.
LoftSection circleSection(double at, double radius);
LoftSection rectangleSection(double at, const Eigen::Vector2d& size, double roundMm,
                             const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

// Returns a pose at `origin` whose z is `axis` and whose x is the component of `across`
// perpendicular to it; any x if `across` is zero or parallel. Precondition: axis is not zero.
Eigen::Isometry3d loftPose(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
                           const Eigen::Vector3d& across = Eigen::Vector3d::Zero());

// A closed surface in the loft's reference frame (frame_T_loft applied). Vertices on sharp edges
// are duplicated, with one normal for each side.
struct LoftMesh {
  geometry::TriangleMesh mesh;
  std::vector<Eigen::Vector3d> normals; // One unit normal per vertex
};
// Precondition: as Loft says.
LoftMesh meshOf(const Loft& loft);

} // namespace voluta::robot
