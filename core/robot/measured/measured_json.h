// Tables of what was measured into frames and tips as JSON text, for `voluta-cli cell`
// (docs/design.md, Command line).
#pragma once

#include "robot/measured/measured_frames.h"
#include "robot/robot_model.h"

#include <string>
#include <vector>

namespace voluta::robot {

using NumberRows = std::vector<std::vector<double>>;

// Three rows x, y, z: origin, a point on x, a point with y > 0; then the residual is 0. Or rows of
// six: a point in the frame, and where it was touched. mm. Throws Error{UnusableInput}: rows of
// another length, three points wanted; as frameFromPoints().
MeasuredFrame frameOfRows(const NumberRows& rows);
// Rows of seven: the flange's x, y, z (mm), qw, qx, qy, qz; or with a robot its joints in degrees,
// sliding ones in mm. Throws Error{UnusableInput}: rows of another length, a quaternion whose
// length is not 1 within 1 %; as toolTip().
MeasuredTip tipOfRows(const NumberRows& rows, const RobotModel* robot);

// {"pose": {xyzMm, rpyDeg} as cells have it, "points": n, "rmsMm", "worstMm", "noiseMm",
// "placeMm", "turnDeg"}: null for what is not known.
std::string frameJson(const MeasuredFrame& measured, std::size_t points);
// {"tipMm", "pointMm", "poses", "rmsMm", "worstMm", "noiseMm", "placeMm"}
std::string tipJson(const MeasuredTip& measured, std::size_t poses);

} // namespace voluta::robot
