// A part cut in two by a plane, with dowels, pegs or a dovetail that join the halves again, and a
// part split into its bodies.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/plane.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// The connection of two halves. Lengths in mm.
struct Joint {
  // Dowels: loose pins in holes of both halves. Pegs: pins of the lower half in holes of the upper
  // one. Dovetail: a tongue of the lower half in a groove of the upper one.
  enum class Kind { None, Dowels, Pegs, Dovetail } kind = Kind::None;
  double sizeMm = 6.0;       // diameter of a pin; width of the tongue at the plane
  double depthMm = 8.0;      // of a pin in each half it enters; height of the tongue
  double clearanceMm = 0.15; // of holes and groove on every side, and at their end
  int count = 2;             // pins in each section of the plane, if there is room
  double directionRad = 0.0; // of the dovetail, from the horizontal
};

struct PartHalves {
  geometry::TriangleMesh below, above;        // closed, facing outward; of one or more bodies
  std::vector<geometry::TriangleMesh> dowels; // loose ones, in their places
  double sectionMm2 = 0.0;
  std::vector<Eigen::Vector3d> pins; // where their axes cross the plane
};

// Cuts the part along the plane and joins the halves. Sections are closed by flat faces; without a
// joint the halves together are the part (planar/plane_cut.h). Pins are perpendicular to the plane,
// far from each other, and leave a wall of 0.3 diameters, at least 1.2 mm, around their holes
// everywhere.
// Precondition (Error{Internal}): sizes are finite; clearance >= 0. Throws Error{UnusableInput} if
// the part is not closed, the plane does not cut it or leaves less than a layer (0.05 mm), there is
// no room for the joint, or the mesh intersects itself at the cut.
PartHalves cutPart(const geometry::TriangleMesh& part, const Plane& plane, const Joint& joint,
                   const base::RunContext& ctx);

// Returns the bodies of a mesh: shells that no edge connects, with their cavities, in the order of
// their first triangles.
std::vector<geometry::TriangleMesh> bodiesOf(const geometry::TriangleMesh& mesh);

} // namespace voluta::planar
