// Converts tables of measurements to frames and tips as JSON text, for `voluta-cli cell`
// (docs/design.md, Command line).
#pragma once

#include "robot/measured/measured_frames.h"
#include "robot/robot_model.h"

#include <string>
#include <vector>

namespace voluta::robot {

using NumberRows = std::vector<std::vector<double>>;

// Three rows x, y, z: origin, a point on x, a point with y > 0; the residual is then 0. Or rows of
// six: a nominal point in the frame, and the touched point. [mm]. Throws Error{UnusableInput} for
// rows of another length or another number of three-point rows, and as frameFromPoints().
MeasuredFrame frameOfRows(const NumberRows& rows);
// Rows of seven: the flange's x, y, z [mm], qw, qx, qy, qz; or with a robot its joints [degrees],
// sliding ones [mm]. Throws Error{UnusableInput} for rows of another length or a quaternion whose
// length is not 1 within 1 %, and as toolTip().
MeasuredTip tipOfRows(const NumberRows& rows, const RobotModel* robot);

// Returns {"pose": {xyzMm, rpyDeg} as in cells, "points": n, "rmsMm", "worstMm", "noiseMm",
// "placeMm", "turnDeg"}: null for unknown values.
std::string frameJson(const MeasuredFrame& measured, std::size_t points);
// Returns {"tipMm", "pointMm", "poses", "rmsMm", "worstMm", "noiseMm", "placeMm"}.
std::string tipJson(const MeasuredTip& measured, std::size_t poses);

} // namespace voluta::robot
