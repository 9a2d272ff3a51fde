// What a cell's files say, as part of a stage's key.
#pragma once

#include "robot/cell.h"

#include <string>

namespace voluta::pipeline {

// Returns the cell's id and its robot's with the hashes of their files. An arm's drawn shape does
// not count. `choice`: Choices::cell, which the cell was loaded from. Throws as robot::loadCell().
std::string cellText(const robot::Cell& cell, const std::string& choice);

} // namespace voluta::pipeline
