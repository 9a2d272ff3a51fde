// The seam of a shoe's upper (Castelli 7.1.2): the outline of the surface that faces up, and copies
// of it further inside.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::substrate {

struct SeamRule {
  double steepRad = 0.6108652381980153; // 35 deg: steeper places are outside
  double closingMm = 2.0;               // gaps of the outline narrower than twice this are closed
  double insetMm = 0.0;                 // of the first curve, seen from above
  double spacingMm = 3.0;               // between curves, seen from above
  int curves = 1;                       // from outside inwards
  double stepMm = 1.0;                  // greatest distance of points
  double leastMm = 10.0;                // shorter outlines are left out
};

// A closed curve on a surface; the first point is not repeated.
struct SeamCurve {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals; // unit, of the surface
  double lengthMm() const;
};

// Returns the curves of all outlines, those of one outline from outside inwards. Outlines are those
// of the places whose normal is within the angle of z, seen from above (the hull of their alpha
// shape: gaps are closed, holes filled); curves follow the highest surface below them. Normals are
// smooth where faces meet at less than 40 deg. Fewer curves are returned where there is no room.
// Throws Cancelled.
std::vector<SeamCurve> seamCurves(const geometry::TriangleMesh& surface, const SeamRule& rule,
                                  const base::RunContext& ctx);

} // namespace voluta::substrate
