// The path of the nozzle's tip over time, for the view.
#pragma once

#include "scene/line_groups.h"
#include "scene/theme.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::robot {
class Cell;
}
namespace voluta::timeline {
class Clock;
}

namespace voluta::window {

// In the work frame [mm]. Point i is reached at timeS[i], depositing material if prints[i].
struct TipTrace {
  std::vector<double> timeS; // ascending
  std::vector<Eigen::Vector3f> tipMm;
  std::vector<char> prints;
};

// Joint motions, whose tips move along curves, have points in between. Throws Cancelled.
// Precondition: the clock is not empty and is of that cell.
TipTrace tipTrace(const timeline::Clock& clock, const robot::Cell& cell,
                  const base::RunContext& ctx);

// Returns the lines from one time to another: solid where the nozzle prints, dashed in the colour
// of travels elsewhere. Of more than about kMaxTracePoints, the straightest places are thinned.
std::vector<scene::LineGroup> traceLines(const TipTrace& trace, double fromS, double toS,
                                         const scene::Theme& theme);
inline constexpr std::size_t kMaxTracePoints = 300'000;
// Gives such lines the colours of another theme.
void colourTrace(std::vector<scene::LineGroup>& lines, const scene::Theme& theme);

} // namespace voluta::window
