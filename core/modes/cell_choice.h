// Loads the chosen cell before its platform is known.
#pragma once

#include "process/process.h"
#include "project/choices.h"
#include "robot/cell.h"

namespace voluta::modes {

// Returns the chosen cell with a placeholder platform of fixed size, for callers that do not depend
// on the platform. Reads the cell's file. Throws Error{Usage, UnreadableFile, UnusableInput}.
robot::Cell cellOnAnyPlatform(const project::Choices& choices, const process::Process& process);

} // namespace voluta::modes
