// A part's rotation as typed by the user: degrees about the fixed axes, X first, then Y, then Z.
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace voluta::project {

// Returns the angles rounded to a thousandth of a degree; of equivalent triples the smallest.
Eigen::Vector3d turnDegrees(const Eigen::Quaterniond& turn);
Eigen::Quaterniond turnOfDegrees(const Eigen::Vector3d& degrees);

// Returns turnDegrees() as text, e.g. "90,0,-45.5".
std::string turnText(const Eigen::Quaterniond& turn);
// Throws Error{Usage}.
Eigen::Quaterniond parsedTurn(const std::string& text);

} // namespace voluta::project
