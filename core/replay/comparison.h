// The program's text against the trajectory it was written from: every difference a finding that
// names its line.
#pragma once

#include "plan/finding.h"
#include "plan/program.h"
#include "plan/trajectory.h"
#include "replay/alignment.h"
#include "replay/executed_path.h"
#include "replay/verification.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// Where the trajectory has the nozzle at each of its points: work frame, mm; unit, -tool z.
struct PlannedNozzle {
  std::vector<Eigen::Vector3d> tip, direction;
};
// Throws Cancelled. Precondition: trajectory.dof == cell.dof().
PlannedNozzle plannedNozzle(const plan::Trajectory& trajectory, const robot::Cell& cell,
                            const base::RunContext& ctx);

// The program's motions and the plan's points, walked in step (alignment.h). Pieces have no point:
// of a joint motion that the dialect cannot say, and of a straight one on a table that turns. Of a
// program that tells no directions they do not count. What is aside has none either, and is no
// deviation. `path`: the program's. Throws Cancelled.
Alignment alignProgram(const plan::ReadProgram& program, const ExecutedPath& path,
                       const PlannedNozzle& planned, const plan::Trajectory& trajectory,
                       const robot::Cell& cell, const base::RunContext& ctx);

struct TextFinding {
  plan::Finding finding;
  TextPlace place;
};

// How a finding names it: with the file where the program has several, its last motion's among
// them.
plan::ProgramLine programLine(TextPlace place, TextPlace lastMotion);
plan::ProgramLine programLine(const plan::ReadProgram& program, TextPlace place);

// Returns a finding at a place of the program's text.
TextFinding textFinding(const plan::ReadProgram& program, plan::FindingKind kind, TextPlace place,
                        std::vector<plan::NamedValue> values, std::size_t count = 1);
TextPlace placeOf(const plan::ReadProgram& program, std::size_t motion);

struct ComparisonOptions {
  double sameMm = 0.05;        // as AlignmentOptions
  double rateTolerance = 0.05; // of time and of material
  double leastS = 1e-3;        // differences of time below are rounding
  double leastMm3 = 0.005;     // differences of material below are rounding
  double jointRad = 0.02;      // an arm's joint further off is another configuration
  double externalRad = 2e-4; // an external axis further off stands elsewhere: the nozzle's path on
                             // the part may be the same, the arm's is not
};

// Deviations of the alignment, defects of the reader and a missing end; and of motions (with their
// pieces) that follow each other as their points do: time (length by speed, of joint motions with
// the ramps that the text gives) and material that
// differ by more than 5 %, the extruder on over a travel or off over a print, a bead by joints,
// joints in another configuration, external axes elsewhere. Differences of one kind in consecutive
// motions are one finding, at the first of them.
std::vector<TextFinding> compareWithPlan(const plan::ReadProgram& program, const ExecutedPath& path,
                                         const PlannedNozzle& planned,
                                         const plan::Trajectory& trajectory,
                                         const Alignment& alignment,
                                         const ComparisonOptions& options);

// Greatest distance of the executed nozzle from the planned polyline, of motions that have a
// point, and greatest angle of its axis at their targets. Joint motions have no polyline: of them
// only the ends count. Throws Cancelled.
struct PathDeviation {
  double mm = 0.0, rad = 0.0;
  std::size_t motion = 0; // of the greatest distance
};
PathDeviation pathDeviation(const ExecutedPath& path, const PlannedNozzle& planned,
                            const plan::Trajectory& trajectory, const plan::ReadProgram& program,
                            const Alignment& alignment, const base::RunContext& ctx);

} // namespace voluta::replay
