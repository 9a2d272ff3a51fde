// The window's pages, in the order of the flow.
#pragma once

#include "window/pages/page.h"

#include <memory>
#include <vector>

namespace voluta::window {

std::vector<std::unique_ptr<Page>> makePages(const Workspace& workspace);

} // namespace voluta::window
