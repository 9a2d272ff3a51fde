// Writes known paths as G-code in the manner of slicers.
#pragma once

#include "plan/tool_plan.h"

#include <string>
#include <string_view>

namespace voluta::test {

enum class Manner {
  Cura,        // ;LAYER:, ;TYPE:WALL-OUTER, absolute E, start code that primes, G0 for travels
  PrusaSlicer, // ;LAYER_CHANGE, ;HEIGHT:, ;WIDTH:, ;TYPE:External perimeter, relative E
  Slic3r       // No comments about layers and features; absolute E, G92 E0 in each layer
};
inline constexpr Manner kManners[] = {Manner::Cura, Manner::PrusaSlicer, Manner::Slic3r};
std::string_view nameOf(Manner manner);

struct Written {
  std::string text;
  double lengthMm = 0.0, volumeMm3 = 0.0; // extruded by the text, without start code
};

// Writes the paths of a plan with upright nozzles; coordinates with three decimals, amounts with
// five, retraction before each travel. `filamentMm`: diameter of the filament.
Written writtenBy(Manner manner, const plan::ToolPlan& plan, double filamentMm = 1.75);

} // namespace voluta::test
