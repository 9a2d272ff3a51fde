// Runs the G-code of a milled part on its block and judges the result.
#pragma once

#include "base/run_context.h"
#include "milling/left_material.h"
#include "milling/mill_passes.h"
#include "milling/mill_reader.h"
#include "milling/stock.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::milling {

struct MillVerdict {
  bool passed = false;              // does no harm; `left` may not be empty
  std::vector<MillDefect> refusals; // at their lines
  double removedMm3 = 0.0;
  double seconds = 0.0;       // feeds by the text, rapid moves at kRapidMmPerMin
  double deepestMm = 0.0;     // greatest depth of material missing from the part, along z
  double residueMm = 0.0;     // greatest thickness of material left on the part
  double sideResidueMm = 0.0; // of it, on the part's lower side
  std::optional<Stock> rest;  // the block afterwards, as side A sees it
  LeftMaterial left;          // in space that should be free

  // Returns whether the program does no harm and leaves nothing.
  bool isComplete() const { return passed && left.volumeMm3 == 0.0; }
};

inline constexpr double kRapidMmPerMin = 1500.0; // an assumption
// Depth up to which missing material counts as rounding: cells of the map, digits of the text.
inline constexpr double kGougeMm = 0.02;

// Moves the cutter through the block. Refuses text that is not understood or ends early; motions
// that are not those of the plan, in its order; a rapid move, or a move with the spindle at rest,
// that touches the block; another feed or speed than planned; the cutter below the block; and
// material missing from the part. Throws Cancelled.
MillVerdict replayMilling(const ReadMilling& program, const MillPlan& plan, const MillRule& rule,
                          const base::RunContext& ctx);

} // namespace voluta::milling
