// The data types of RAPID used in programs for printing.
#pragma once

#include "base/text.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// A literal as its numbers in order and its shape: n number, b boolean (0 or 1), s string ("" is 0,
// else 1), within the literal's brackets.
struct RapidData {
  std::string shape;
  std::vector<double> numbers;
  std::string text; // Text of its string, in lower case
};

// Returns the shape of a type's literals; empty for an unknown type. `type` in lower case.
std::string_view rapidShape(std::string_view type);

// Tool and work object state whether the robot holds them: it holds one of the two.
inline bool holdsObject(const RapidData& object) {
  return object.numbers[0] == 1.0;
}
// Returns whether a mechanical unit moves the work object.
inline bool isMoved(const RapidData& object) {
  return object.numbers[1] == 0.0;
}

// Returns data that every controller predeclares: v5..v7000, fine, z0..z200, tool0, wobj0. `type`
// and `name` in lower case.
std::optional<RapidData> predeclaredRapid(std::string_view type, std::string_view name);

// Maximum coordinate of a position, beyond every robot's reach
inline constexpr double kMaxRapidMm = 1e5;

// Reads the position and quaternion of a literal from numbers[at] on. Returns false, with the
// reason, if the position is out of every robot's reach or the quaternion's length is not 1.
bool rapidPose(const std::vector<double>& numbers, std::size_t at, Eigen::Isometry3d& pose,
               base::Message& reason);

} // namespace voluta::program
