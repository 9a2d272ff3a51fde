// A cell's file, as it is edited, looked at: can it be read, and what can it not do?
#pragma once

#include "base/run_context.h"
#include "cells/cell_check.h"
#include "process/process.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

// `text`: what the file of a cell of that id would hold. With the largest of its plates, a disc of
// 200 mm where it has none. Throws Error{UnreadableFile, UnusableInput} as robot::Cell::readText().
robot::Cell cellOfText(const std::string& text, const std::string& id,
                       const process::Process& process);

struct CheckedCell {
  std::shared_ptr<const robot::Cell> cell; // null: it cannot be read
  std::vector<cells::CellFault> faults;    // why not, or what it cannot do
};

// The cell of that text, and its faults. `partKg` as cells::cellFaults(). Throws Cancelled.
CheckedCell checkedCell(const std::string& text, const std::string& id,
                        const process::Process& process, double partKg,
                        const base::RunContext& ctx);

} // namespace voluta::pipeline
