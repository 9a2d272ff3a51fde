// The data types of RAPID that a program for printing declares or names.
#pragma once

#include "base/text.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// A literal as its numbers in order and its shape: n number, b truth (0 or 1), s string ("" is 0,
// else 1), within the literal's brackets.
struct RapidData {
  std::string shape;
  std::vector<double> numbers;
  std::string text; // of its string, in small letters
};

// The shape of a type's literals; empty: a type that is not known. `type` in small letters.
std::string_view rapidShape(std::string_view type);

// Tool and work object say whether the robot holds them: one of the two.
inline bool holdsObject(const RapidData& object) {
  return object.numbers[0] == 1.0;
}
// Does a mechanical unit move the work object?
inline bool isMoved(const RapidData& object) {
  return object.numbers[1] == 0.0;
}

// What every controller declares by itself: v5..v7000, fine, z0..z200, tool0, wobj0. `type` and
// `name` in small letters.
std::optional<RapidData> predeclaredRapid(std::string_view type, std::string_view name);

inline constexpr double kMostRapidMm = 1e5; // of a position; further off is no robot's reach

// Position and quaternion of a literal, from numbers[at]. false, and the reason: out of any reach,
// or a quaternion whose length is not 1.
bool rapidPose(const std::vector<double>& numbers, std::size_t at, Eigen::Isometry3d& pose,
               base::Message& reason);

} // namespace voluta::program
