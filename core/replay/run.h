// A program's run, apart from the words that say it: material, what it rests on, what meets.
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

// A program as it runs.
struct Run {
  ExecutedPath path;
  std::vector<double> volumeMm3;        // per motion
  std::vector<std::size_t> pointOf;     // per motion: its point of the trajectory, or kUnmatched
  std::vector<std::size_t> commonPoint; // likewise, by its number for all programs of the plan
  std::vector<BeadKnowledge> knowledge; // per motion
};

// Something about the beads, found at one motion or nowhere in particular.
struct BeadFinding {
  plan::FindingKind kind;
  std::vector<plan::NamedValue> values;
  std::optional<Eigen::Vector3d> where;
  std::optional<std::size_t> motion;
  std::size_t count = 1;
};

// The material of a run, as laid.
struct LaidBeads {
  std::vector<LaidPiece> pieces;
  BeadGrid beads; // without fill
  std::optional<PrintedPart> printed;
  std::optional<Underside> underside; // of the head over the pieces
};

// A run with what was found in it. Kept for others to be lent, it is without what no other asks:
// its targets, lengths and durations, the arm between them, its points and what is known of them.
struct JudgedRun {
  Run run;
  std::shared_ptr<const LaidBeads> laid;
  RunFigures figures;             // collisions and collidingWaypoints of the clashes below
  std::vector<BeadFinding> beads; // by the thresholds that it was judged with
  std::vector<Clash> head, arm;   // in no order
};

// Lays the run's beads and looks for what meets. The input's program is not asked.
//
// A run of `judged` that lays the same beads lends its own, and its clashes for the motions that
// are the same; the first such run. Motions are the same where tip and head keep within half a cell
// of the beads' grid (nearer it tells no contact) and the material is the same; beads are, where
// all that extrude are the same and lie, by volume, no more than a tenth of a cell apart in the
// mean. Throws Cancelled.
JudgedRun judgeRun(Run run, const ReplayInput& input, const ReplayThresholds& thresholds,
                   const JudgedRuns& judged, const base::RunContext& ctx);

// What a run that is told of is kept as.
JudgedRun strippedForReuse(JudgedRun run);

// How far a motion of one run is from the motion of another to the same point of the plan.
struct Apart {
  std::size_t motion = kUnmatched; // of the other run; kUnmatched: it has none
  double tipMm = 0.0;  // the nozzle's tip from the other's way, at most; either way round
  double headMm = 0.0; // the head's far end likewise
};
// Per motion of b, from those of a, by their common points; `reachMm`: of the head along its axis.
// Throws Cancelled.
std::vector<Apart> apart(const Run& a, const Run& b, double reachMm, const base::RunContext& ctx);

} // namespace voluta::replay
