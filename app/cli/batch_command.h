// Writes and runs a batch.
#pragma once

#include "cli/batch_request.h"
#include "cli/exit_code.h"

namespace voluta::cli {

// Returns kDone if all jobs are done and verified.
ExitCode batchCommand(const BatchOptions& options);

} // namespace voluta::cli
