// The seam of a shoe's upper (Castelli 7.1.2): the outline of the surface that faces up, copies of
// it further inside, passes on the side below it, and parallel lines that fill heel and toe.
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
  double minMm = 10.0;                  // shorter curves are left out, but not fillLines
  int sideCurves = 0;                   // on the side, from above downwards
  double sideDepthMm = 5.0;             // of the first of them below the outline, along z
  // At each of the two ends, inside the innermost curve; none that is shorter than spacingMm.
  int fillLines = 0;
  double fillRad = 1.5707963267948966; // angle of these lines to x, seen from above
};

// A curve on a surface; the first point of a closed one is not repeated.
struct SeamCurve {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals; // unit, of the surface
  bool isClosed = true;
  double lengthMm() const;
};

// Returns the curves of all outlines, those of one outline from outside inwards. Outlines are those
// of the places whose normal is within the angle of z, seen from above (the hull of their alpha
// shape: gaps are closed, holes filled); curves follow the highest surface below them. Normals are
// smooth where faces meet at less than 40 deg. Fewer curves are returned where there is no room.
// The curves of an outline are followed by those on its side, where the surface beside the outline
// is that far below it, and by its lines. The ends are where the space inside the innermost curve
// ends across the lines; the lines are as far apart as the curves. Throws Cancelled.
std::vector<SeamCurve> seamCurves(const geometry::TriangleMesh& surface, const SeamRule& rule,
                                  const base::RunContext& ctx);

} // namespace voluta::substrate
