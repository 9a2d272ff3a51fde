// An extruder that the controller runs as an additional external axis (by step and direction, or by
// the controller's own drive). It is a linear axis in mm of filament that moves with each motion,
// so that a bead gets its material at any speed of the arm.
//
// The axis counts from 0 over the whole program. As controllers keep numbers to 24 bits and an axis
// has a range, the program stops, lifted off, before a bead that would leave the range, for the
// axis to be reset to 0.
#pragma once

#include "base/parameters.h"
#include "program/program_input.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr std::string_view kAxisExtruder = "external-axis";
inline constexpr std::string_view kAxisQuestion =
    "Set the extruder's axis to 0 mm where it stands, then go on.";

// mm of filament until the axis is reset to 0.
base::ParameterSpec extruderAxisMm();

struct AxisCount {
  // Points, ascending, before whose motions the axis is reset to 0: the first, and as many others
  // as the range requires.
  std::vector<std::size_t> zeros;
  double maxMm = 0.0; // the largest axis value
};
// Throws Error{Usage} if more is printed between two lifts than the range.
AxisCount axisCount(const ProgramInput& input);

// Returns the note for the program's head; `axis`: the axis' name in the dialect.
std::string axisNote(std::string_view axis, const AxisCount& count);

} // namespace voluta::program
