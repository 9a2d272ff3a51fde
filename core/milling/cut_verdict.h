// Moves the cutter of a milled part's program through its block and judges the result.
#pragma once

#include "base/run_context.h"
#include "milling/left_material.h"
#include "milling/mill_passes.h"
#include "milling/stock.h"
#include "plan/finding.h"
#include "plan/program.h"

#include <optional>

namespace voluta::milling {

struct CutVerdict {
  bool passed = false; // does no harm; `left` may not be empty
  // Each blocks. Places are those of the part as side A sees it; lines are those of the text.
  plan::Findings findings;
  double removedMm3 = 0.0;
  double seconds = 0.0;        // feeds by the text, rapid moves at kRapidMmPerMin
  double maxDeviationMm = 0.0; // of the motions that are those of the plan
  double deepestMm = 0.0;      // greatest depth of material missing from the part, along z
  double residueMm = 0.0;      // greatest thickness of material left on the part
  double sideResidueMm = 0.0;  // of it, on the part's lower side
  std::optional<Stock> rest;   // the block afterwards, as side A sees it
  LeftMaterial left;           // in space that should be free

  // Returns whether the program does no harm and leaves nothing.
  bool isComplete() const { return findings.empty(); }
};

inline constexpr double kRapidMmPerMin = 1500.0; // an assumption
// Depth up to which missing material counts as rounding: cells of the map, digits of the text.
inline constexpr double kGougeMm = 0.02;
inline constexpr double kSamePlaceMm = 0.002; // digits of the text

// `program`: as program::readMillingGcode() returns it. Refuses text that is not understood or ends
// early; motions that are not those of the plan, in its order; a block that turns below the cutter,
// or is not turned as the plan needs it; a rapid move, or a move with the spindle at rest, that
// touches the block; another feed or speed than planned; the cutter below the block; and material
// missing from the part. Motions that are refused for the same are one finding, at the first of
// them. A program that passes but leaves material has the finding MaterialLeft. Throws
// Cancelled.
CutVerdict judgeCuts(const plan::ReadProgram& program, const MillPlan& plan, const MillRule& rule,
                     const base::RunContext& ctx);

} // namespace voluta::milling
