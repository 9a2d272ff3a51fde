// Corrections of a machine's sizes from measured parts, such as sample:accuracy-plate (Castelli
// 5.1.1).
#pragma once

#include "process/process.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::process {

enum class SizeKind : std::uint8_t {
  Length, // between outer sides
  Slot,   // between inner sides
  Hole    // diameter of a round hole
};

struct MeasuredSize {
  SizeKind kind = SizeKind::Length;
  char axis = 'x'; // Of Length and Slot: x or y; a hole has both
  double nominalMm = 0.0, measuredMm = 0.0;
};

// Reads rows "length x 50 49.8", "slot y 5 4.8" and "hole 10 9.6": kind, axis, nominal and measured
// size [mm], separated by commas, semicolons, tabs or blanks; text after # is ignored. Throws
// Error{UnusableInput} with the line for anything else, sizes that are not positive or that differ
// by more than a fifth and 2 mm, and if there is no row.
std::vector<MeasuredSize> readMeasuredSizes(std::string_view text, std::string_view source);

struct SizeFit {
  Process process;         // as printed, with new corrections
  double residualMm = 0.0; // greatest difference of a measured size from the fitted law
  // Standard deviations of the fitted factors along x and y [mm/mm]. Without sizes that tell a
  // factor from an excess, such as one short length, they are kUnknownFactor.
  double scaleDeviationX = 0.0, scaleDeviationY = 0.0;
};
// Error that a machine's factor usually has [mm/mm]: what is known of it without any size.
inline constexpr double kUnknownFactor = 0.002;
// Returns whether the sizes tell a factor with this standard deviation.
constexpr bool tellsScale(double deviation) {
  return deviation < 0.5 * kUnknownFactor;
}

// Fits a factor along x and y, an excess of outlines and one of holes to the sizes (least squares,
// with the errors that machines usually have as a prior), and returns the process with which they
// would be right. `printed`: the process of the measured parts, whose corrections they have.
// Throws Error{UnusableInput} if the corrections leave the ranges of a process.
SizeFit fitSizes(std::span<const MeasuredSize> sizes, const Process& printed);

} // namespace voluta::process
