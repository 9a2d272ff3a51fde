// The cell that was chosen, before there is a platform in it.
#pragma once

#include "process/process.h"
#include "project/choices.h"
#include "robot/cell.h"

namespace voluta::modes {

// With a platform of some size, for what does not depend on the platform. Reads its file. Throws
// Error{Usage, UnreadableFile, UnusableInput}.
robot::Cell cellOnAnyPlatform(const project::Choices& choices, const process::Process& process);

} // namespace voluta::modes
