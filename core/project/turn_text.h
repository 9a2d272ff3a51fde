// A part's rotation as typed by the user: degrees about the fixed axes, X first, then Y, then Z.
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace voluta::project {

// Returns the angles rounded to a thousandth of a degree; of equivalent triples the smallest.
Eigen::Vector3d rotationDegrees(const Eigen::Quaterniond& rotation);
Eigen::Quaterniond rotationOfDegrees(const Eigen::Vector3d& degrees);

// Returns rotationDegrees() as text, e.g. "90,0,-45.5".
std::string rotationText(const Eigen::Quaterniond& rotation);
// Throws Error{Usage}.
Eigen::Quaterniond parsedRotation(const std::string& text);

} // namespace voluta::project
