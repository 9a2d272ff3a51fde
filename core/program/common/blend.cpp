#include "program/common/blend.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace voluta::program {

double angleRad(const Eigen::Vector3d& in, const Eigen::Vector3d& out) {
  return in.norm() > 0.0 && out.norm() > 0.0 ? std::atan2(in.cross(out).norm(), in.dot(out)) : 0.0;
}

double blendDeviationMm(double radiusMm, double angleRad) {
  return radiusMm * std::tan(angleRad / 4.0);
}

double blendRadiusMm(const BlendSegment& in, const BlendSegment& out, double toleranceMm) {
  const double shortest = std::min(in.tcpMm, out.tcpMm);
  if (!(shortest > 0.0))
    return 0.0;
  const double a = in.nozzle.norm(), b = out.nozzle.norm();
  // Measured on the nozzle's path; a segment on which the nozzle does not move makes no angle.
  const double angle = angleRad(in.nozzle, out.nozzle);
  // Nozzle travel per mm of TCP path; the larger side bounds the corner that is cut off.
  const double perTcpMm = std::max(a / in.tcpMm, b / out.tcpMm);
  const double deviationPerMm = blendDeviationMm(perTcpMm, angle);
  double radius = kBlendShare * shortest;
  if (deviationPerMm * radius > toleranceMm)
    radius = toleranceMm / deviationPerMm;
  return radius;
}

} // namespace voluta::program
