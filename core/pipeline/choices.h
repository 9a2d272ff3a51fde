// From what the user typed to what the stages take.
#pragma once

#include "base/parameters.h"
#include "pipeline/job.h"
#include "process/process.h"
#include "robot/cell.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <optional>
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

// Checks the text of --platform without a part. Throws Error{Usage} that names what there is.
void checkPlatform(const std::string& platform);
// The polygon of "fit", "fit:MARGIN", "disc:D" or "rect:WxD". `own`: the platform that the part
// brought along, which "fit" then stands for; empty: none, and "fit" is the hull of what stands on
// the plate. Throws Error{Usage}; Error{UnusableInput} when nothing of the part stands on the
// plate.
std::vector<Eigen::Vector2d> platformPolygon(const std::string& platform,
                                             const voxel::SolidVoxels& voxels,
                                             const std::vector<Eigen::Vector2d>& own = {});
// The margin of "fit" or "fit:MARGIN", mm; none for other platforms. Throws Error{Usage}.
std::optional<double> fitMargin(const std::string& platform);
// The same where what stands on the plate is given by points of it; they do not matter to a disc or
// a rectangle. Throws Error{UnusableInput} where "fit" has none.
std::vector<Eigen::Vector2d> platformAround(const std::string& platform,
                                            std::vector<Eigen::Vector2d> standing);

// Millimetres that a unit of length of the loaded part's mesh stands for at scale 1: voxelMm for
// a voxel object, else 1. Throws Error{Usage}: the parameters.
double unitMm(const LoadedPart& loaded, const Choices& choices);

// The chosen cell with a platform of some size, for what does not depend on the platform. Reads its
// file. Throws Error{Usage, UnreadableFile, UnusableInput}.
robot::Cell cellOnAnyPlatform(const Choices& choices, const process::Process& process);

// A number > 0, or "fit" (returns 0). Throws Error{Usage}.
double parsedScale(const std::string& scale);

// Throws Error{Usage} for a placement that is no rotation or not finite, and for any name that
// nothing answers to, naming the nearest.
void checkChoices(const Choices& choices);

} // namespace voluta::pipeline
