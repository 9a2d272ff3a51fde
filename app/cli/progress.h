// Progress on stderr: a bar, JSON lines or nothing.
#pragma once

#include "base/run_context.h"

#include <memory>

namespace voluta::cli {

enum class ProgressStyle { Bar, Json, None };

// A sink of the style; a bar is drawn only on a terminal. Updates are limited to ten a second.
// `title` comes before what is being done, where there is one; the run's thread may change it.
base::ProgressSink progressSink(ProgressStyle style,
                                std::shared_ptr<const base::Message> title = {});
// Ends a line that a bar has begun.
void endProgress(ProgressStyle style);

} // namespace voluta::cli
