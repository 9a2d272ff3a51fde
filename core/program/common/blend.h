// Maximum blend radius of the corner between two straight motions.
//
// Assumed geometry: with a blend of radius r the TCP leaves the first line r before the corner and
// joins the second r after it, on a curve inside the triangle of these two points and the corner.
// The widest curve in use, a circular arc tangent to both lines, passes the corner at r tan(turn /
// 4); a parabola (constant acceleration) passes it at r/2 sin(turn / 2), which is never more.
// Position and orientation are blended with the same law.
//
// The tolerance applies to the printed path, not to the TCP's path in Base. With the plate on the
// flange, the nozzle's path on the part follows, to first order, from the six coordinates of the
// pose: a blend that begins at the share r/L1 of the motion before the corner begins, on the part,
// at the same share of the nozzle's displacement. Hence a segment has both lengths.
#pragma once

#include <Eigen/Core>

namespace voluta::program {

// A straight motion: length of the TCP's path in Base, displacement of the nozzle's tip in the work
// frame [mm].
struct BlendSegment {
  double tcpMm = 0.0;
  Eigen::Vector3d nozzle = Eigen::Vector3d::Zero();
};

// Returns the angle between two directions, in [0, pi]; 0 if one has no length.
double angleRad(const Eigen::Vector3d& in, const Eigen::Vector3d& out);

// Maximum share of the shorter neighbour that a blend takes: two blends on one segment never
// overlap.
inline constexpr double kBlendShare = 0.45;

// Returns the distance of the corner from the arc that rounds it [mm]. angleRad in [0, pi]: 0 is
// straight on.
double blendDeviationMm(double radiusMm, double angleRad);

// Returns the largest blend radius (TCP, mm) at the corner of `in` and `out` that takes at most
// kBlendShare of either TCP path and deviates from the nozzle's corner by at most `toleranceMm`. 0
// if a segment has no TCP path to blend on.
double blendRadiusMm(const BlendSegment& in, const BlendSegment& out, double toleranceMm);

} // namespace voluta::program
