// Threads that the window never waits for.
#pragma once

#include <functional>

namespace voluta::jobs {

// Runs `work` on a separate thread at low priority, so that the GUI thread stays responsive;
// threads started by `work` inherit that priority. If such threads are still running when the
// process exits, they are given 0.3 s; then the process ends at once with its exit status, without
// destroying objects that they may be using. `work` must not throw.
void startInBackground(std::function<void()> work);

} // namespace voluta::jobs
