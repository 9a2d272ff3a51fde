// Omission of a trajectory's points that a program does not need within a tolerance, merging of
// points and slowing of short motions, for controllers that must plan each
// motion in time: points too close to each other raise errors or stop the arm. Merged printing
// motions are straight on the part. Joint motions that continue the preceding one are merged as
// well, since the arm would stop between them.
#pragma once

#include "base/run_context.h"
#include "program/program_input.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace voluta::program {

struct MergeLimits {
  double minS = 0.0, minMm = 0.0; // shorter printing motions are merged with the next; 0: none
  // Tolerances between omitted points and the merged motion: position of the tip, nozzle axis, and
  // relative bead section.
  double toleranceMm = 0.004, toleranceRad = 0.01, sectionShare = 0.02;
  double motionS = 0.0;  // minimum duration of a motion; shorter ones are slowed, with less flow
  double jointRad = 0.0; // tolerance for merging a joint motion with the next; 0: no merging
  // Omits all points of beads that are within the tolerances, not only those of short motions. The
  // omitted motions must then also take their share of the merged motion's time.
  bool all = false;
  double speedShare = 0.1; // relative
  double arcMm = 0.0;      // tolerance of arcs; 0: no arcs
  bool levelArcs = false;  // only in planes of X and Y
  // The controller moves the TCP straight in Base, which matters if the arm holds the part.
  bool inBase = false;
};

struct MergedPoints {
  // The input's own trajectory, which must outlive this, if there is nothing to merge or slow.
  std::shared_ptr<const plan::Trajectory> trajectory;
  std::vector<std::size_t> pointOf; // per point of the input: the merged point that ends its motion
  std::vector<ArcVia> arcs;         // motions of `trajectory` that are arcs, ascending
};

// Omits points between two Print motions while the motion to the preceding point is shorter than
// wanted and all omitted points are within the tolerances; times and material are summed. Also
// merges joint motions along one line in joint space, and replaces beads along a circle by arcs.
// Points at which anything else begins or ends are kept. Then slows motions that are still too
// short. Throws Error{Internal} (preconditions of ProgramInput), Cancelled.
MergedPoints mergedPoints(const ProgramInput& input, const MergeLimits& limits,
                          const base::RunContext& ctx);

} // namespace voluta::program
