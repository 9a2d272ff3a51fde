// Progress on stderr: a bar, JSON lines or nothing.
#pragma once

#include "base/run_context.h"

namespace voluta::cli {

enum class ProgressStyle { Bar, Json, None };

// A sink of the style; a bar is drawn only on a terminal. Updates are limited to ten a second.
base::ProgressSink progressSink(ProgressStyle style);
// Ends a line that a bar has begun.
void endProgress(ProgressStyle style);

} // namespace voluta::cli
