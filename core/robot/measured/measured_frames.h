// Frames and tool tips from what was measured at the real cell: points touched with a tip that is
// known, and flange poses in which an unknown tip touches one point.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::robot {

// How well measured numbers agree, and what that leaves open of the result, mm and rad.
struct Residual {
  double rmsMm = 0.0, worstMm = 0.0; // distances of the points from where the result has them
  // Standard deviation of a coordinate that explains them; nothing where there are just as many
  // numbers as unknowns, which always agree.
  std::optional<double> noiseMm;
  // The same of the result in its worst direction, if the noise is as told: of the origin (the
  // tip), and of the frame's turn (0 of a tip). Nothing where the noise is not known.
  std::optional<double> placeMm, turnRad;
};

struct MeasuredFrame {
  Eigen::Isometry3d base_T_frame = Eigen::Isometry3d::Identity();
  Residual residual;
};

// The frame whose origin is `origin`, whose x goes through `onX`, and in whose half plane y > 0
// lies `inPlane`. mm, in the base. Throws Error{UnusableInput}: the three on a line (the least
// angle between them below 0.1 degrees), or a number that is not finite.
Eigen::Isometry3d frameFromPoints(const Eigen::Vector3d& origin, const Eigen::Vector3d& onX,
                                  const Eigen::Vector3d& inPlane);

struct TouchedPoint {
  Eigen::Vector3d inFrame, inBase; // mm: as drawn, and as touched
};
// The frame that brings points of known place in it to where they were touched, by least squares;
// no mirror image. Source: Kabsch 1976, with the sign of Umeyama 1991, eq. 40.
// Throws Error{UnusableInput}: fewer than three, all on a line (the second extent below 1/500 of
// the first), in either list, or a number that is not finite.
MeasuredFrame frameFromPoints(const std::vector<TouchedPoint>& points);

struct MeasuredTip {
  Eigen::Vector3d tipInFlange = Eigen::Vector3d::Zero(); // mm
  Eigen::Vector3d pointInBase = Eigen::Vector3d::Zero(); // that all poses touch
  Residual residual;
};
// The tip that all these flange poses (base_T_flange) hold at one point, by least squares: R_i tip
// + p_i = point. Throws Error{UnusableInput}: fewer than four poses, two of which are the same,
// turned about one axis only or hardly at all (the least singular value of R_i - mean R, a pose,
// below 0.02: about 2 degrees), or numbers that are not finite.
MeasuredTip toolTip(const std::vector<Eigen::Isometry3d>& base_T_flange);

} // namespace voluta::robot
