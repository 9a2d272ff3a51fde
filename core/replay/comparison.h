// Comparison of a program's text with the trajectory it was written from; every difference is a
// finding with its line.
#pragma once

#include "plan/finding.h"
#include "plan/program.h"
#include "plan/trajectory.h"
#include "replay/alignment.h"
#include "replay/executed_path.h"
#include "replay/verification.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// The planned nozzle pose at each point of the trajectory: tip in the work frame [mm]; direction as
// a unit vector, -tool z.
struct PlannedNozzle {
  std::vector<Eigen::Vector3d> tip, direction;
};
// Precondition: trajectory.dof == cell.dof(). Throws Cancelled.
PlannedNozzle plannedNozzle(const plan::Trajectory& trajectory, const robot::Cell& cell,
                            const base::RunContext& ctx);

// Aligns the program's motions with the plan's points (alignment.h). Intermediate pieces have no
// point: pieces of a joint motion that the dialect cannot express, and pieces of a straight motion
// on a rotating table. If the program states no directions, these are ignored. Motions marked as
// aside have no point and are no deviation. `path`: that of the program. Throws Cancelled.
Alignment alignProgram(const plan::ReadProgram& program, const ExecutedPath& path,
                       const PlannedNozzle& planned, const plan::Trajectory& trajectory,
                       const robot::Cell& cell, const base::RunContext& ctx);

struct TextFinding {
  plan::Finding finding;
  TextPlace place;
};

// Returns the line as shown in a finding; it includes the file if the program has several, which
// the position of the last motion determines.
plan::ProgramLine programLine(TextPlace place, TextPlace lastMotion);
plan::ProgramLine programLine(const plan::ReadProgram& program, TextPlace place);

// Returns a finding at a position in the program's text.
TextFinding textFinding(const plan::ReadProgram& program, plan::FindingKind kind, TextPlace place,
                        std::vector<plan::NamedValue> values, std::size_t count = 1);
TextPlace placeOf(const plan::ReadProgram& program, std::size_t motion);

struct ComparisonOptions {
  double sameMm = 0.05;        // as in AlignmentOptions
  double rateTolerance = 0.05; // relative, of time and of material
  double minS = 1e-3;          // smaller differences in time are rounding errors
  double minMm3 = 0.005;       // smaller differences in material are rounding errors
  double jointRad = 0.02;      // an arm joint that differs by more is in another configuration
  // an external axis that differs by more is misplaced: the nozzle's path on the part may be the
  // same, but the arm's is not
  double externalRad = 2e-4;
  // acceleration of the arm's joints: a joint motion that is a piece of a planned one stops at its
  // ends, and may take the time of its ramps; 0: unknown
  double armRadPerS2 = 0.0;
};

// Returns findings about deviations of the alignment, defects found by the reader and a missing
// end. For motions (with their pieces) that follow each other as their points do, it also compares
// time (length divided by speed; joint motions with the ramps given in the text) and material, with
// a tolerance of 5 %, and reports an extruder that is on during a travel or off during a print, a
// bead printed by a joint motion, joints in another configuration, and misplaced external axes.
// Differences of one kind in consecutive motions form one finding at the first of them.
std::vector<TextFinding> compareWithPlan(const plan::ReadProgram& program, const ExecutedPath& path,
                                         const PlannedNozzle& planned,
                                         const plan::Trajectory& trajectory,
                                         const Alignment& alignment,
                                         const ComparisonOptions& options);

// The planned nozzle before its points were merged. The motion to merged point j replaces the
// points up to lastOf[j].
struct WholePath {
  PlannedNozzle planned;
  std::vector<std::size_t> lastOf;
};
// Returns nullopt if no points were merged. Throws Cancelled.
std::optional<WholePath> wholePath(const WholePlan& whole, const plan::Trajectory& merged,
                                   const robot::Cell& cell, const base::RunContext& ctx);

// Largest distance of the executed nozzle from the planned polyline, over motions with a point, and
// largest angle between the nozzle axes at their targets. With `whole`, the polyline is that before
// merging, and the distance of its points from the executed motion counts as well. Joint motions
// have no polyline: only their ends count. Throws Cancelled.
struct PathDeviation {
  double mm = 0.0, rad = 0.0;
  std::size_t motion = 0; // motion with the largest distance
};
PathDeviation pathDeviation(const ExecutedPath& path, const PlannedNozzle& planned,
                            const plan::Trajectory& trajectory, const plan::ReadProgram& program,
                            const Alignment& alignment, const base::RunContext& ctx,
                            const WholePath* whole = nullptr);

} // namespace voluta::replay
