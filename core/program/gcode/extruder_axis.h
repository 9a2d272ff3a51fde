// An extruder that a controller turns as one more external axis (issued as step and direction, or
// by the controller's own drive): a linear axis whose mm are mm of filament and that goes with each
// motion, so that a bead gets its material however fast the arm passes.
//
// It counts on from 0 over a whole program. A controller keeps numbers to 24 bits and an axis has a
// range: where the next bead would leave that, the program stops, lifted off, for the axis to be
// set to 0 anew, and counts from there.
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

// mm of filament until the axis is set to 0.
base::ParameterSpec extruderAxisMm();

struct AxisCount {
  // Points, ascending, before whose motions the axis is set to 0: the first, and as many behind it
  // as the range needs.
  std::vector<std::size_t> zeros;
  double mostMm = 0.0; // that it comes to
};
// Throws Error{Usage}: between two lifts more is laid than the range.
AxisCount axisCount(const ProgramInput& input);

// What the head says of it; `axis`: what the dialect calls it.
std::string axisNote(std::string_view axis, const AxisCount& count);

} // namespace voluta::program
