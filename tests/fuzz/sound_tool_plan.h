// Invariants of every tool plan that a reader returns.
#pragma once

#include "fuzz_target.h"
#include "plan/tool_plan.h"

#include <cmath>
#include <cstddef>

namespace voluta::fuzz {

inline void expectSound(const plan::ToolPlan& plan) {
  std::size_t next = 0;
  for (const plan::ToolPath& path : plan.paths) {
    expect(path.first == next && path.count >= 2, "paths cover the points in turn");
    next += path.count;
  }
  expect(next == plan.waypointCount(), "paths cover all points");
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    expect(plan.position[i].allFinite(), "positions are finite");
    expect(std::abs(plan.direction[i].norm() - 1.0) < 1e-6, "directions are unit vectors");
    expect(std::isfinite(plan.widthMm[i]) && plan.widthMm[i] >= 0.0f, "widths are sound");
    expect(std::isfinite(plan.heightMm[i]) && plan.heightMm[i] >= 0.0f, "heights are sound");
    expect(std::isfinite(plan.speedMmPerS[i]) && plan.speedMmPerS[i] >= 0.0f, "speeds are sound");
  }
}

} // namespace voluta::fuzz
