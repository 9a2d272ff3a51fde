// Threads that the window never waits for.
#pragma once

#include <functional>

namespace voluta::jobs {

// Runs `work` on a thread of its own at low priority, so that the GUI thread keeps breathing; the
// threads that `work` starts inherit that priority. When the process exits while such threads
// still run, they are given 0.3 s; then the process ends at once with its exit status, without
// destroying what they may be using. `work` must not throw.
void startInBackground(std::function<void()> work);

} // namespace voluta::jobs
