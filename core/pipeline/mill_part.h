// A part milled out of a block: laid down, planned, written as G-code, and judged on its block.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "milling/cut_verdict.h"
#include "milling/mill_passes.h"
#include "placement/laying_down.h"
#include "project/report.h"

#include <cstddef>
#include <string>

namespace voluta::pipeline {

struct MillOrder {
  std::string name; // of the part, for the program's first comment
  milling::MillRule rule;
  bool layDown = true; // false: the part keeps its orientation
};

struct MilledPart {
  placement::MillingOrientation orientation; // no turn if it was not wanted
  geometry::TriangleMesh part;               // as milled
  milling::MillPlan plan;
  std::string program;
  std::size_t motions = 0; // of the program
  milling::CutVerdict verdict;
  project::Timings timings; // load, toolpath and replay
};

// Throws as milling::planMilling(). Precondition: the part is closed and faces outward.
MilledPart millPart(geometry::TriangleMesh part, const MillOrder& order,
                    const base::RunContext& ctx);

} // namespace voluta::pipeline
