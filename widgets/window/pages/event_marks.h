// The events of a program on its time-line.
#pragma once

#include "timeline/clock.h"
#include "timeline/timeline_bar.h"

#include <vector>

namespace voluta::window {

// Pauses, outputs, changes of the tool, own statements, and the waits that are asked for, in their
// order. `asked`: the seconds of those waits.
std::vector<timeline::EventMark> eventMarks(const timeline::Clock& clock,
                                            const std::vector<double>& asked);

} // namespace voluta::window
