// The run of a program independent of its language: material, its support and collisions.
#pragma once

#include "plan/finding.h"
#include "replay/alignment.h"
#include "replay/beads.h"
#include "replay/clashes.h"
#include "replay/executed_path.h"
#include "replay/printed_part.h"
#include "replay/underside.h"
#include "replay/verification.h"

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// A program's execution.
struct Run {
  ExecutedPath path;
  std::vector<double> volumeMm3;    // per motion
  std::vector<std::size_t> pointOf; // per motion: its point of the trajectory, or kUnmatched
  // as pointOf, but with the numbering common to all programs of the plan
  std::vector<std::size_t> commonPoint;
  std::vector<BeadKnowledge> knowledge; // per motion
};

// A finding about the beads, at one motion or at none in particular.
struct BeadFinding {
  plan::FindingKind kind;
  std::vector<plan::NamedValue> values;
  std::optional<Eigen::Vector3d> where;
  std::optional<std::size_t> motion;
  std::size_t count = 1;
};

// The deposited material of a run.
struct LaidBeads {
  std::vector<LaidPiece> pieces;
  BeadGrid beads; // without fill
  std::optional<PrintedPart> printed;
  std::optional<Underside> underside; // of the head, against the pieces
};

// A run and its results. A run kept for reuse lacks the data that no other run needs: its targets,
// lengths and durations, the arm's configurations between them, its points and their knowledge.
struct JudgedRun {
  Run run;
  std::shared_ptr<const LaidBeads> laid;
  RunFigures figures; // collisions and collidingWaypoints are those of the clashes below
  std::vector<BeadFinding> beads; // for the thresholds it was judged with
  std::vector<Clash> head, arm;   // unordered
};

// Deposits the run's beads and checks them for support and collisions. Does not use the input's
// program.
//
// Reuses the beads of the first run of `judged` that deposits the same ones, and its clashes for
// unchanged motions. Motions are unchanged if tip and head stay within half a cell of the bead grid
// (contacts are not resolved more finely) and the material is the same. Beads are the same if all
// extruding motions have a counterpart and are, weighted by volume, at most a tenth of a cell apart
// in the mean. Throws Cancelled.
JudgedRun judgeRun(Run run, const ReplayInput& input, const ReplayThresholds& thresholds,
                   const JudgedRuns& judged, const base::RunContext& ctx);

// Returns a judged run without the data that reuse does not need.
JudgedRun strippedForReuse(JudgedRun run);

// The distance of a motion in one run from the motion to the same point of the plan in another.
struct Apart {
  std::size_t motion = kUnmatched; // of the other run; kUnmatched: none
  double tipMm = 0.0;  // maximum distance of the tip from the other's path, in both directions
  double headMm = 0.0; // same for the far end of the head
};
// Returns an entry per motion of b, compared with the motions of a by their common points.
// `reachMm`: of the head along its axis. Throws Cancelled.
std::vector<Apart> apart(const Run& a, const Run& b, double reachMm, const base::RunContext& ctx);

} // namespace voluta::replay
