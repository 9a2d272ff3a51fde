// Frames and tool tips from measurements at the real cell: points touched with a known tip, and
// flange poses in which an unknown tip touches one point.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::robot {

// How well measured numbers agree, and the resulting uncertainty [mm, rad].
struct Residual {
  double rmsMm = 0.0, worstMm = 0.0; // Distances of the points from their fitted positions
  // Standard deviation per coordinate that explains them; nullopt without redundant numbers, which
  // always agree.
  std::optional<double> noiseMm;
  // Standard deviation of the result in its worst direction, given this noise: of the origin (the
  // tip), and of the frame's rotation (0 for a tip). nullopt if the noise is unknown.
  std::optional<double> placeMm, angleRad;
};

struct MeasuredFrame {
  Eigen::Isometry3d base_T_frame = Eigen::Isometry3d::Identity();
  Residual residual;
};

// Returns the frame [mm] in the base with its origin at `origin`, its x through `onX`, and
// `inPlane` in its half plane y > 0. Throws Error{UnusableInput} if the three are on a line (the
// smallest angle between them below 0.1 degrees), or a number is not finite.
Eigen::Isometry3d frameFromPoints(const Eigen::Vector3d& origin, const Eigen::Vector3d& onX,
                                  const Eigen::Vector3d& inPlane);

struct TouchedPoint {
  Eigen::Vector3d inFrame, inBase; // [mm]: nominal, and as touched
};
// Returns the frame that maps points of known position in it to where they were touched, by least
// squares, without mirroring. Source: Kabsch 1976, with the sign of Umeyama 1991, eq. 40. Throws
// Error{UnusableInput} if there are fewer than three points, if all are on a line in either list
// (the second extent below 1/500 of the first), or if a number is not finite.
MeasuredFrame frameFromPoints(const std::vector<TouchedPoint>& points);

struct MeasuredTip {
  Eigen::Vector3d tipInFlange = Eigen::Vector3d::Zero(); // [mm]
  Eigen::Vector3d pointInBase = Eigen::Vector3d::Zero(); // Point that all poses touch
  Residual residual;
};
// Returns the tip that all these flange poses (base_T_flange) hold at one point, by least squares:
// R_i tip + p_i = point. Throws Error{UnusableInput} if there are fewer than four poses, if two of
// them are the same, if they rotate about one axis only or hardly at all (the smallest singular
// value of R_i - mean R, per pose, below 0.02: about 2 degrees), or if numbers are not finite.
MeasuredTip toolTip(const std::vector<Eigen::Isometry3d>& base_T_flange);

} // namespace voluta::robot
