// Time, length and mass of the beads of each kind.
#pragma once

#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "timeline/clock.h"

#include <array>
#include <optional>
#include <vector>

namespace voluta::window {

struct KindFigures {
  double timeS = 0.0, lengthMm = 0.0, massG = 0.0;
};

struct KindStatistics {
  std::array<KindFigures, plan::kPathKinds> kinds;
  double travelS = 0.0; // Everything except printing: travels, waits, tool changes
  bool timed = false;   // Without a motion all times are 0

  // Of all kinds, travel included.
  KindFigures total() const;
};

struct PrintStatistics {
  KindStatistics whole;
  std::vector<KindStatistics> layers; // By index; without travel
};

// `clock` may be null: then there are no times.
PrintStatistics printStatistics(const plan::ToolPlan& plan, const process::Tooling& tooling,
                                const timeline::Clock* clock);

} // namespace voluta::window
