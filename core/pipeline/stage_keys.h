// Cache keys of the stages: their inputs as text (docs/design.md, Stages: cached by what went in).
#pragma once

#include "project/job_stage.h"

#include <span>
#include <string>

namespace voluta::base {
class ParameterValues;
}
namespace voluta::layers {
enum class PrintOrder;
}
namespace voluta::modes {
struct LoadStage;
struct ModeChoices;
} // namespace voluta::modes
namespace voluta::process {
class Tooling;
}
namespace voluta::program {
struct ProgramOptions;
}
namespace voluta::project {
struct Choices;
struct LoadedPart;
} // namespace voluta::project

namespace voluta::pipeline {

struct Resolved;

// Returns the keys of all stages. A stage's key is the key of the stage before plus its own inputs,
// so that a change invalidates exactly the stages that depend on it. Throws Error{Usage,
// UnreadableFile, UnusableInput} for the cell. Precondition: the choices are checked.
project::StageKeys keysOf(const project::LoadedPart& loaded, const Resolved& resolved);

// Returns the keys of a job from those of its items: up to Layers all items' keys, then the joined
// layers' keys with the settings that the items share. A single item's keys are the job's.
// Precondition: at least one item.
project::StageKeys joinedKeys(std::span<const project::StageKeys> items, layers::PrintOrder order);

// Returns the inputs that determine a placed part, as text. It excludes the platform, so that ways
// of building share results that depend on the part alone.
std::string placedPartKey(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                          const Resolved& resolved);

// Returns the key of one program of the Replay stage.
std::string programKey(const project::StageKeys& keys, const std::string& partName,
                       const Resolved& resolved, const std::string& format);

} // namespace voluta::pipeline
