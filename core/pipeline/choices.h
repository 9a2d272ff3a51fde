// From what the user typed to what the stages take.
#pragma once

#include "base/parameters.h"
#include "pipeline/job.h"
#include "process/process.h"
#include "robot/cell.h"

#include <string>
#include <vector>

namespace voluta::pipeline {

// The values of choices.parameters over allParameters(). Throws Error{Usage}.
base::ParameterValues parameterValues(const Choices& choices);

// "key=value" a line of the parameters of `table` as `values` have them.
std::string parameterText(const base::ParameterTable& table, const base::ParameterValues& values);
// The same of these keys, which must be known.
std::string parameterText(std::initializer_list<const char*> keys,
                          const base::ParameterValues& values);

// The ids of choices.formats, or what stands in for an empty list in this cell.
std::vector<std::string> chosenFormats(const Choices& choices, const robot::Cell& cell);

// The process of choices with the parameters layerHeightMm, beadWidthMm and stepMm put in.
// Throws Error{Usage}: unknown process, a value outside the process's limits (names them).
process::Process chosenProcess(const Choices& choices, const base::ParameterValues& values);

// Millimetres that a unit of length of the loaded part's mesh stands for at scale 1: voxelMm for
// a voxel object, else 1. Throws Error{Usage}: the parameters.
double unitMm(const LoadedPart& loaded, const Choices& choices);

// The chosen cell with a platform of some size, for what does not depend on the platform. Reads its
// file. Throws Error{Usage} also where the mode needs a rod and the cell has none, or the cell has
// one and the mode does not print on it; Error{UnreadableFile, UnusableInput}.
robot::Cell cellOnAnyPlatform(const Choices& choices, const process::Process& process);

// A number > 0, or "fit" (returns 0). Throws Error{Usage}.
double parsedScale(const std::string& scale);

// Throws Error{Usage} for a placement that is no rotation or not finite, and for any name that
// nothing answers to, naming the nearest.
void checkChoices(const Choices& choices);

} // namespace voluta::pipeline
