// Converts the user's choices to the options of the stages.
#pragma once

#include "base/parameters.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::layers {
struct ToolAssignment;
}
namespace voluta::motion {
struct MotionOptions;
}
namespace voluta::process {
struct Process;
class Tooling;
} // namespace voluta::process
namespace voluta::project {
struct Choices;
struct ItemChoices;
struct LoadedPart;
class Platform;
} // namespace voluta::project
namespace voluta::robot {
class Cell;
}
namespace voluta::toolpath {
struct ToolpathOptions;
}

namespace voluta::pipeline {

// Returns the parameters of all modules in one table.
base::ParameterTable allParameters();
// Checks "key=value" texts against the table and stores them: those of the job in
// choices.parameters, those of items in the first item. If a value names a file that holds its text
// (base::ParameterFile::read), that text is stored. Returns a note for each renamed key, whose old
// name is accepted. Throws Error{Usage}, Error{UnreadableFile}.
std::vector<base::Message> setParameters(project::Choices& choices,
                                         const std::vector<std::string>& assignments);
// As above, for one item. Also throws Error{Usage} for a parameter of the job.
std::vector<base::Message> setItemParameters(project::ItemChoices& item,
                                             const std::vector<std::string>& assignments);

// Returns where the values of that scope are stored: in the choices, or in their first item.
std::map<std::string, std::string>& parametersOf(project::Choices& choices,
                                                 base::ParameterScope scope);
// Returns the non-default values of the job and of its first item.
std::map<std::string, std::string> givenParameters(const project::Choices& choices);

// Returns allParameters() with the defaults of a mode; unchanged if no mode has that id.
base::ParameterTable parametersOf(std::string_view mode);
// As above, with the defaults of the process too: its bead sizes, and lengths that grow with wider
// beads. If the process cannot be read, only the mode's defaults apply.
base::ParameterTable parametersOf(const project::Choices& choices);

// Returns givenParameters() on top of parametersOf(). Throws Error{Usage}.
base::ParameterValues parameterValues(const project::Choices& choices);

// Returns the ids of choices.formats, or this cell's default formats if the list is empty.
std::vector<std::string> chosenFormats(const project::Choices& choices, const robot::Cell& cell);

// Returns whether the cell and each of its chosen formats can tilt the nozzle on the part.
bool canTilt(const project::Choices& choices, const robot::Cell& cell);

// Throws Error{Usage} if `assignments` ("key=value") contains an option of programs that none of
// the formats to be written has.
void requireOptionsApply(const project::Choices& choices,
                         const std::vector<std::string>& assignments);

// Returns the process of the part's tool with the parameters layerHeightMm, beadWidthMm and stepMm
// applied. Throws Error{Usage} for an unknown process, and for a value outside the process's limits
// (names the limits).
process::Process chosenProcess(const project::Choices& choices,
                               const base::ParameterValues& values);

// Returns the index of the tool that prints the part of the choices (parameter `tool`).
std::size_t ownTool(const project::Choices& choices);

// Removes a tool but the first. What it prints is printed by the first one; later tools keep their
// assignments. Precondition: 0 < tool < choices.tools.size().
void removeTool(project::Choices& choices, std::size_t tool);

// Returns the tools of the choices: that of the part with chosenProcess(), the others with their
// processes and the part's layer height, as far as they can print it. All have one head that
// contains those of all. Throws as chosenProcess().
process::Tooling chosenTooling(const project::Choices& choices,
                               const base::ParameterValues& values);

// Returns the tools that print the part, its supports, its interior and its pieces. `tooling`: as
// chosenTooling(). Throws as layers::toolAssignment(); Error{Usage} if one of them cannot print the
// part's layer height.
layers::ToolAssignment chosenTools(const base::ParameterValues& values,
                                   const process::Tooling& tooling);
// Throws Error{Usage} if a tool cannot print layers of that height. `tool`: an index.
void requirePrints(const process::Tooling& tooling, int tool, double layerHeightMm);

// Returns the length [mm] of one unit of the loaded part's mesh at scale 1. For a voxel object this
// is the user's voxelMm, or else the parameter's default regardless of mode and process. Throws
// Error{Usage} for invalid parameters.
double unitMm(const project::LoadedPart& loaded, const project::Choices& choices);

// As modes::cellOnAnyPlatform. Also throws Error{Usage} if the mode needs a rod and the cell has
// none, or if the cell has a rod and the mode does not print on one.
robot::Cell fittingCell(const project::Choices& choices, const process::Process& process);

// Returns the tool-path options for these values; the platform is not included.
toolpath::ToolpathOptions toolpathOptionsOf(const base::ParameterValues& values,
                                            const process::Process& process);
motion::MotionOptions motionOptionsOf(const base::ParameterValues& values, int seed);

// Returns the default platform for the mode of the choices: the smallest plate of the cell that
// carries the part. In cells without plates, in modes that print on no plate, and for modes that
// cut the part into pieces (whose bases the head has to reach from below) it is the first kind of
// the platform table. Throws Error{Usage} for unknown names; throws as loadCell.
project::Platform usualPlatform(const project::Choices& choices);

// Throws Error{Usage} for a placement that is not a rotation or not finite, and for unknown names
// (suggests the nearest).
void checkChoices(const project::Choices& choices);

// Replaces the file names of cell and process (FILE.json), and the ids of own processes, by the
// content of these files, so that a project keeps the data it was planned with. Throws
// Error{UnreadableFile, UnusableInput} naming the file.
void takeOwnFiles(project::Choices& choices);

} // namespace voluta::pipeline
