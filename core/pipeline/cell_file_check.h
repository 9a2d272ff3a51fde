// Checks a cell file while it is being edited: whether it can be read, and its faults.
#pragma once

#include "base/run_context.h"
#include "cells/cell_check.h"
#include "process/process.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

// Returns the cell that `text`, the content of the file of cell `id`, describes, with the largest
// of its plates, or with a disc of 200 mm if it has none. Throws Error{UnreadableFile,
// UnusableInput} as robot::Cell::readText().
robot::Cell cellOfText(const std::string& text, const std::string& id,
                       const process::Process& process);

struct CheckedCell {
  std::shared_ptr<const robot::Cell> cell; // nullptr if the text cannot be read
  std::vector<cells::CellFault> faults;    // The reading error, or the cell's limitations
};

// Returns the cell described by `text`, and its faults. `partKg` as in cells::cellFaults(). Throws
// Cancelled.
CheckedCell checkedCell(const std::string& text, const std::string& id,
                        const process::Process& process, double partKg,
                        const base::RunContext& ctx);

} // namespace voluta::pipeline
