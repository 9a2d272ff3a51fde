// Bead sections of a sliced file: area from the amount over the length, height from comments or
// the distance of layers, width from both.
#pragma once

#include "plan/tool_plan.h"
#include "sliced/sliced_file.h"

#include <cstddef>
#include <vector>

namespace voluta::sliced {

// Returns the beads as tool-paths, in the order and coordinates of the file. The volume of each
// path is exactly that of its amounts: a waypoint's area is the mean of the segments beside it,
// weighted with their lengths, and a step of the section is spread over at most 0.25 mm. Heights
// that are not known are 0. Beads thinner than round are round ones of that area. Paths without
// comments are walls if they are closed and do not go to and fro, else infill. Layers count from 0
// by comments, or by height. `filamentMm2`: section of the filament; 1 for amounts that are
// volumes. `lines`, if given: the line in which each path of the plan begins.
plan::ToolPlan beadsOf(const SlicedFile& file, double filamentMm2,
                       std::vector<std::size_t>* lines = nullptr);

// Return the volume of all beads, and of one path [mm3].
double beadsMm3(const plan::ToolPlan& plan);
double beadsMm3(const plan::ToolPlan& plan, const plan::ToolPath& path);

} // namespace voluta::sliced
