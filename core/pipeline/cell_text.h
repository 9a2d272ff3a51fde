// The content of a cell's files, as part of a stage's cache key.
#pragma once

#include "robot/cell.h"

#include <string>

namespace voluta::pipeline {

// Returns the cell's id and its robot's id with the hashes of their files. The visual meshes of an
// arm do not count. `choice`: the Choices::cell that the cell was loaded from. Throws as
// robot::loadCell().
std::string cellText(const robot::Cell& cell, const std::string& choice);

} // namespace voluta::pipeline
