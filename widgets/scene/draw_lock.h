// One frame at a time in the process: VTK keeps its OpenGL functions (GLEW) and its fonts
// (FreeType) in tables that all windows share and that drawing changes.
#pragma once

#include <mutex>

namespace voluta::scene {

// Returns the lock to hold while a window, on screen or off, is drawn. Do not draw inside of it
// again on the same thread.
std::unique_lock<std::mutex> drawLock();

} // namespace voluta::scene
