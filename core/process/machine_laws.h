// The optional laws of a process's machine in its file: lags of the extruder, overlap of beads,
// statements where beads start and end.
#pragma once

#include "base/json_node.h"
#include "process/process.h"

namespace voluta::process {

// Reads the keys startLagS, stopLagS, overlapFactor and beadWords. With an overlap factor, the
// file's bead widths are those of single beads: they become the widths of beads that fill a layer
// at this share of them. Throws Error{UnusableInput} for
// a negative lag or one above 10 s, a factor outside [0.5, 1], a format that has its statements
// twice or none, and a statement that is empty or has several lines.
void readMachineLaws(const base::JsonNode& top, Process& process);

} // namespace voluta::process
