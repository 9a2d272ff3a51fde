// Progress on stderr: a bar, JSON lines or nothing.
#pragma once

#include "base/run_context.h"

#include <memory>

namespace voluta::cli {

enum class ProgressStyle { Bar, Json, None };

// Returns a progress sink of the style; a bar is drawn only on a terminal. At most ten updates per
// second. `title`, if given, precedes the current step; the thread of the run may change it.
base::ProgressSink progressSink(ProgressStyle style,
                                std::shared_ptr<const base::Message> title = {});
// Ends the line of an unfinished bar.
void endProgress(ProgressStyle style);

} // namespace voluta::cli
