// What goes into each stage, as text (DESIGN §3: cached by what went in).
#pragma once

#include "base/parameters.h"
#include "pipeline/job.h"
#include "pipeline/stage.h"
#include "process/process.h"

#include <string>

namespace voluta::pipeline {

// A stage's key is that of the stage before and what it adds itself, so that a change reaches all
// that follows and nothing else. Throws Error{Usage, UnreadableFile, UnusableInput}: the cell.
// Precondition: the choices are checked.
StageKeys keysOf(const LoadedPart& loaded, const Choices& choices,
                 const base::ParameterValues& values, const process::Process& process);

// The key of one program of the Replay stage.
std::string programKey(const StageKeys& keys, const std::string& partName,
                       const process::Process& process, const std::string& format);

} // namespace voluta::pipeline
