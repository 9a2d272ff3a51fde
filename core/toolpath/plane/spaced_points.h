// Points of a line in a plane as waypoints.
#pragma once

#include "toolpath/plane/field_lines.h"

namespace voluta::toolpath {

// Returns the line with as few points as keep it within `chordMm` (Douglas and Peucker 1973), but
// evenly spaced between them, at most `stepMm` apart. Preconditions: two points or more; both
// lengths > 0.
PlaneLine spacedPoints(const PlaneLine& line, double chordMm, double stepMm);

} // namespace voluta::toolpath
