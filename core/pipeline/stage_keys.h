// What goes into each stage, as text (docs/design.md, Stages: cached by what went in).
#pragma once

#include "base/parameters.h"
#include "modes/from_options.h"
#include "modes/stages.h"
#include "process/process.h"
#include "program/program_options.h"
#include "project/job.h"
#include "project/stage.h"

#include <span>
#include <string>

namespace voluta::pipeline {

// A stage's key is that of the stage before and what it adds itself, so that a change reaches all
// that follows and nothing else. Throws Error{Usage, UnreadableFile, UnusableInput}: the cell.
// Precondition: the choices are checked.
project::StageKeys keysOf(const project::LoadedPart& loaded, const project::Choices& choices,
                          const base::ParameterValues& values, const process::Process& process);

// The keys of a job from those of its items: up to Layers all items', then the joined layers' by
// the settings that the items share. Those of a single item are its own.
// Precondition: there is one at least.
project::StageKeys joinedKeys(std::span<const project::StageKeys> items, layers::PrintOrder order);

// What decides about a placed part, as text: nothing of a platform, so that ways of building share
// what is made of the part alone.
std::string placedPartKey(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                          const modes::ModeChoices& in);

// The key of one program of the Replay stage.
std::string programKey(const project::StageKeys& keys, const std::string& partName,
                       const process::Process& process, const program::ProgramOptions& options,
                       const std::string& format);

} // namespace voluta::pipeline
