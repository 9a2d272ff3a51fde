// Writes processes as files.
#pragma once

#include "process/process.h"

#include <string>

namespace voluta::process {

// Returns the text of a process's file: readProcessText() returns the same process, on any machine.
// A material that does not come with the program is stored within the text.
std::string processText(const Process& process);

// Returns whether all values are equal, those of material, head and features included.
bool sameProcess(const Process& a, const Process& b);

} // namespace voluta::process
