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
#include <cstdint>
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
  std::vector<double> shotMm3;      // per motion: flows into a pocket where it ends; empty: none
  std::vector<std::size_t> pointOf; // per motion: its point of the trajectory, or kUnmatched
  // as pointOf, but with the numbering common to all programs of the plan
  std::vector<std::size_t> commonPoint;
  std::vector<BeadKnowledge> knowledge; // per motion
  std::vector<std::uint8_t> tool;       // per motion: the one that deposits
  // Per motion: on the controller's clock [s], waits included (controller_time.h)
  std::vector<double> beginS, endS;
  std::size_t firstMotion = 0; // as in plan::ReadProgram; motions before it have no clock
};

// A finding about the beads, at one motion or at none in particular.
struct BeadFinding {
  plan::FindingKind kind;
  std::vector<plan::NamedValue> values;
  std::optional<Eigen::Vector3d> where;
  std::optional<std::size_t> motion;
  std::size_t count = 1;
  int item = -1; // as plan::Finding::item
};

// The deposited material of a run.
struct DepositedBeads {
  std::vector<DepositedPiece> pieces;
  std::vector<std::uint32_t> below; // per piece: the last one directly below it, or kNeverFilled
  BeadGrid beads;                   // without fill
  std::optional<PrintedPart> printed;
  std::optional<Underside> underside; // of the head, against the pieces
};

// A run and its results.
struct JudgedRun {
  Run run; // without the arm's configurations between targets
  std::shared_ptr<const DepositedBeads> deposited;
  RunFigures figures; // collisions and collidingWaypoints are those of the clashes below
  std::vector<BeadFinding> beads;      // for the thresholds it was judged with
  std::vector<Clash> head, arm;        // unordered
  std::vector<BeadFinding> layerTimes; // by the run's own clock
};

// Results of a run that are known before it is judged, say from another program with the same
// motions. They are taken as they are. Motions are numbered as in the run that is judged.
struct KnownResults {
  std::shared_ptr<const DepositedBeads> deposited; // null: nothing is known; all else is then empty
  RunFigures figures;                              // of the beads
  std::vector<BeadFinding> beads;                  // for the same thresholds
  std::vector<std::uint32_t> firstPiece; // of each motion among deposited->pieces (clashes.h)
  std::vector<char> headKnown, armKnown; // per motion: its clashes of head, arm are known
  std::vector<Clash> head, arm;          // all clashes that begin in known motions
};

// Deposits the run's beads and checks them for support and collisions, except for what is known.
// Does not use the input's program. Throws Cancelled.
JudgedRun judgeRun(Run run, const ReplayInput& input, const ReplayThresholds& thresholds,
                   KnownResults known, const base::RunContext& ctx);

} // namespace voluta::replay
