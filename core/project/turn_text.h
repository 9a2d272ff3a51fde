// How a part is turned, as a user types it: degrees about the fixed axes, X first, then Y, then Z.
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace voluta::project {

// To a thousandth of a degree; the angles nearest to no turn.
Eigen::Vector3d turnDegrees(const Eigen::Quaterniond& turn);
Eigen::Quaterniond turnOfDegrees(const Eigen::Vector3d& degrees);

// "90,0,-45.5": turnDegrees().
std::string turnText(const Eigen::Quaterniond& turn);
// Throws Error{Usage}.
Eigen::Quaterniond parsedTurn(const std::string& text);

} // namespace voluta::project
