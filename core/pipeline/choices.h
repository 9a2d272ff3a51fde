// From what the user typed to what the stages take.
#pragma once

#include "base/parameters.h"
#include "motion/motion_options.h"
#include "planar/pieces.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/loaded_part.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// Every module's parameters in one table.
base::ParameterTable allParameters();
// Checks "key=value" texts against the table and keeps them in choices.parameters.
// Throws Error{Usage}, also for a value that cannot be printed yet.
void setParameters(project::Choices& choices, const std::vector<std::string>& assignments);

// allParameters() without those that are not offered yet: no form, list or help shows them.
base::ParameterTable offeredParameters();

// allParameters() with the defaults that a mode has; as they are where no mode has that id.
base::ParameterTable parametersOf(std::string_view mode);
// With those of the process too: sizes of its beads, and lengths that grow with wider beads. The
// mode's alone where the process cannot be read.
base::ParameterTable parametersOf(const project::Choices& choices);

// The values of choices.parameters over allParameters(). Throws Error{Usage}.
base::ParameterValues parameterValues(const project::Choices& choices);

// The ids of choices.formats, or what stands in for an empty list in this cell.
std::vector<std::string> chosenFormats(const project::Choices& choices, const robot::Cell& cell);

// Throws Error{Usage} for an option of programs that is among `assignments` ("key=value") and that
// none of the formats to be written has.
void requireOptionsApply(const project::Choices& choices,
                         const std::vector<std::string>& assignments);

// The process of choices with the parameters layerHeightMm, beadWidthMm and stepMm put in.
// Throws Error{Usage}: unknown process, a value outside the process's limits (names them).
process::Process chosenProcess(const project::Choices& choices,
                               const base::ParameterValues& values);

// Millimetres that a unit of length of the loaded part's mesh stands for at scale 1. For a voxel
// object the user's voxelMm, else its default without what a mode or a process make of it.
// Throws Error{Usage}: the parameters.
double unitMm(const project::LoadedPart& loaded, const project::Choices& choices);

// modes::cellOnAnyPlatform. Throws Error{Usage} also where the mode needs a rod and the cell has
// none, or the cell has one and the mode does not print on it.
robot::Cell fittingCell(const project::Choices& choices, const process::Process& process);

// What the stages after the layers are asked for; of the tool-paths' but for the platform.
toolpath::ToolpathOptions toolpathOptionsOf(const base::ParameterValues& values,
                                            const process::Process& process);
motion::MotionOptions motionOptionsOf(const base::ParameterValues& values, int seed);

// When faces of pieces need support. Throws Error{Usage}: parameters, process.
planar::RiskRule riskRule(const project::Choices& choices);

// What material starts on where nobody chose it for the choices' mode: the plate of their cell that
// fits; in a cell without plates, for what no plate carries, and for pieces, which a head has to
// reach from below their bases, the first kind of the table.
// Throws Error{Usage}: names that nothing answers to; as loadCell.
project::Platform usualPlatform(const project::Choices& choices);

// Throws Error{Usage} for a placement that is no rotation or not finite, and for any name that
// nothing answers to, naming the nearest.
void checkChoices(const project::Choices& choices);

// Replaces file names of cell and process (FILE.json) by the text of these files, so that a project
// keeps what it was made with. Throws Error{UnreadableFile, UnusableInput} naming the file.
void takeOwnFiles(project::Choices& choices);

} // namespace voluta::pipeline
