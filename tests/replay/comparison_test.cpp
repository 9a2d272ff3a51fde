// A program's motions against the points it was written from: two short beads by hand.
#include "replay/comparison.h"

#include "base/run_context.h"
#include "plan/finding_kinds.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;
using plan::FindingKind;
using plan::MoveKind;

constexpr double kArea = 0.8;

// Points 0 to 15: down to a bead of six steps, up and over by joints, down, and five steps more.
// Motion m is in line 10 + m.
struct Job {
  plan::ReadProgram program;
  plan::Trajectory trajectory;
  PlannedNozzle planned;

  Job() {
    program.complete = true;
    add(MoveKind::Joint, {0, 0, 20}, 50);
    add(MoveKind::Linear, {0, 0, 1}, 50);
    for (int i = 1; i <= 6; ++i)
      add(MoveKind::Print, {1.0 * i, 0, 1}, 20);
    add(MoveKind::Linear, {6, 0, 10}, 50);
    add(MoveKind::Joint, {0, 8, 10}, 50);
    add(MoveKind::Linear, {0, 8, 1}, 50);
    for (int i = 1; i <= 5; ++i)
      add(MoveKind::Print, {2.0 * i, 8, 1}, 20);
  }
  void add(MoveKind move, const Vector3d& tip, double speed) {
    const bool first = planned.tip.empty();
    const double step = first ? 0.0 : (tip - planned.tip.back()).norm();
    const bool prints = move == MoveKind::Print;
    planned.tip.push_back(tip);
    planned.direction.push_back(Vector3d::UnitZ());
    trajectory.move.push_back(move);
    trajectory.timeS.push_back(first ? 0.0 : trajectory.timeS.back() + step / speed);
    trajectory.extrudedMm3.push_back((first ? 0.0 : trajectory.extrudedMm3.back()) +
                                     (prints ? kArea * step : 0.0));
    plan::ProgramMotion m;
    m.line = 10 + program.motions.size();
    m.target = plan::TargetKind::ToolPoint;
    m.position = tip;
    m.speedMmPerS = speed;
    m.extruding = prints;
    m.volumeMm3 = prints ? kArea * step : -1.0;
    program.motions.push_back(m);
  }
  Alignment aligned(const ExecutedPath& path) const {
    return alignToPlan({path.targetTip, path.targetDirection}, {planned.tip, planned.direction},
                       AlignmentOptions{}, {});
  }
  // "kind line count" of each.
  std::vector<std::string> findings() const {
    const ExecutedPath path = executeToolPoints(program, {});
    std::vector<std::string> reported;
    for (const TextFinding& f :
         compareWithPlan(program, path, planned, trajectory, aligned(path), ComparisonOptions{}))
      reported.push_back(reportOf(f.finding.kind, f.place.line, f.finding.count));
    return reported;
  }
  PathDeviation deviation() const {
    const ExecutedPath path = executeToolPoints(program, {});
    return pathDeviation(path, planned, trajectory, program, aligned(path), {});
  }
  static std::string expected(FindingKind kind, std::size_t motion, std::size_t count = 1) {
    return reportOf(kind, 10 + motion, count);
  }
  // Several kinds may share a word.
  static std::string reportOf(FindingKind kind, std::size_t line, std::size_t count) {
    return std::string(plan::rowOf(kind).reportId) + '/' + std::to_string(static_cast<int>(kind)) +
           " line " + std::to_string(line) + " x" + std::to_string(count);
  }
};

using Reported = std::vector<std::string>;

TEST(Comparison, PlansOwnProgramGivesNoFinding) {
  const Job job;
  EXPECT_EQ(job.findings(), Reported{});
  EXPECT_EQ(job.deviation().mm, 0.0);
  EXPECT_EQ(job.deviation().rad, 0.0);
}

TEST(Comparison, ASpeedMayDifferByATwentieth) {
  for (const double by : {0.94, 0.96, 1.0, 1.04, 1.06}) {
    SCOPED_TRACE(by);
    Job job;
    for (const std::size_t m : {4u, 10u})
      job.program.motions[m].speedMmPerS /= by;
    const bool changed = by < 0.95 || by > 1.05;
    EXPECT_EQ(job.findings(), changed ? (Reported{job.expected(FindingKind::SpeedChanged, 4),
                                                  job.expected(FindingKind::SpeedChanged, 10)})
                                      : Reported{});
  }
  // Differences below a millisecond are rounding.
  for (const double later : {0.9e-3, 1.1e-3}) {
    Job job;
    for (plan::ProgramMotion& m : job.program.motions)
      m.speedMmPerS *= 10.0;
    for (double& t : job.trajectory.timeS)
      t /= 10.0;
    job.program.motions[3].durationS = 1.0 / 200.0 + later;
    EXPECT_EQ(job.findings(),
              later > 1e-3 ? Reported{job.expected(FindingKind::SpeedChanged, 3)} : Reported{});
  }
}

TEST(Comparison, MaterialMayDifferByATwentieth) {
  for (const double by : {0.94, 0.96, 1.04, 1.06}) {
    Job job;
    for (const std::size_t m : {3u, 13u})
      job.program.motions[m].volumeMm3 *= by;
    const bool changed = by < 0.95 || by > 1.05;
    EXPECT_EQ(job.findings(), changed ? (Reported{job.expected(FindingKind::FlowChanged, 3),
                                                  job.expected(FindingKind::FlowChanged, 13)})
                                      : Reported{})
        << by;
  }
  // Of hardly anything a few thousandths are rounding.
  for (const double more : {0.004, 0.006}) {
    Job job;
    for (std::size_t j = 0; j < job.trajectory.extrudedMm3.size(); ++j)
      job.trajectory.extrudedMm3[j] *= 0.01;
    for (plan::ProgramMotion& m : job.program.motions)
      m.volumeMm3 *= m.extruding ? 0.01 : 1.0;
    job.program.motions[5].volumeMm3 += more;
    EXPECT_EQ(job.findings(),
              more > 0.005 ? Reported{job.expected(FindingKind::FlowChanged, 5)} : Reported{});
  }
}

// At a rate, a slower motion deposits more: that is one finding, not two.
TEST(Comparison, SlowerOrHigherRateGivesOneFinding) {
  for (const bool slower : {false, true}) {
    Job job;
    for (plan::ProgramMotion& m : job.program.motions)
      if (m.extruding) {
        m.volumeMm3 = -1.0;
        m.flowMm3PerS = kArea * 20.0;
      }
    if (slower)
      job.program.motions[4].speedMmPerS = 10.0;
    else
      job.program.motions[4].flowMm3PerS *= 1.3;
    EXPECT_EQ(
        job.findings(),
        Reported{job.expected(slower ? FindingKind::SpeedChanged : FindingKind::FlowChanged, 4)});
  }
}

TEST(Comparison, ConsecutiveChangesGiveOneFinding) {
  Job job;
  for (const std::size_t m : {3u, 4u, 5u, 12u, 14u})
    job.program.motions[m].volumeMm3 *= 2.0;
  EXPECT_EQ(job.findings(), (Reported{job.expected(FindingKind::FlowChanged, 3, 3),
                                      job.expected(FindingKind::FlowChanged, 12),
                                      job.expected(FindingKind::FlowChanged, 14)}));
}

// Two kinds side by side, each in a row.
TEST(Comparison, ChangesOfTwoKindsGiveTwoFindings) {
  Job job;
  for (const std::size_t m : {3u, 4u, 5u}) {
    job.program.motions[m].volumeMm3 *= 2.0;
    job.program.motions[m].speedMmPerS *= 2.0;
  }
  EXPECT_EQ(job.findings(), (Reported{job.expected(FindingKind::SpeedChanged, 3, 3),
                                      job.expected(FindingKind::FlowChanged, 3, 3)}));
}

TEST(Comparison, TheExtruderIsOnWhereItPrintsAndNowhereElse) {
  Job job;
  job.program.motions[8].extruding = true;
  job.program.motions[8].volumeMm3 = 1.0;
  job.program.motions[13].extruding = false;
  EXPECT_EQ(job.findings(), (Reported{job.expected(FindingKind::ExtruderOnTravel, 8),
                                      job.expected(FindingKind::ExtruderOffPrint, 13)}));
  // Where the text begins, an extruder that is on and lays nothing is no harm.
  for (const double volume : {0.0, 0.004, 0.006}) {
    Job first;
    first.program.motions[0].extruding = true;
    first.program.motions[0].volumeMm3 = volume;
    EXPECT_EQ(first.findings(), volume > 0.005
                                    ? Reported{first.expected(FindingKind::ExtruderOnTravel, 0)}
                                    : Reported{});
  }
}

TEST(Comparison, DeviationsDefectsAndAMissingEndGiveFindings) {
  Job job;
  job.program.motions[5].position.z() += 0.3;
  EXPECT_EQ(job.findings(), Reported{job.expected(FindingKind::WaypointMoved, 5)});
  job = Job();
  job.program.motions[5].direction = {std::sin(0.1), 0, std::cos(0.1)};
  EXPECT_EQ(job.findings(), Reported{job.expected(FindingKind::WaypointTilted, 5)});
  job = Job();
  std::swap(job.program.motions[4].position, job.program.motions[5].position);
  EXPECT_EQ(job.findings().front(), job.expected(FindingKind::WaypointsSwapped, 4, 2));
  job = Job();
  job.program.motions.erase(job.program.motions.begin() + 4, job.program.motions.begin() + 6);
  EXPECT_EQ(job.findings().front(), Job::reportOf(FindingKind::WaypointsMissingBetween, 16, 2));
  job = Job();
  job.program.motions.resize(13);
  EXPECT_EQ(job.findings(), Reported{job.expected(FindingKind::ProgramCutShort, 12, 3)});
  job = Job();
  job.program.complete = false;
  EXPECT_EQ(job.findings(), Reported{job.expected(FindingKind::EndMissing, 15)});
  job.program.defects.push_back({0, 17, {}});
  EXPECT_EQ(job.findings(), (Reported{job.expected(FindingKind::UnreadableLine, 7),
                                      job.expected(FindingKind::EndMissing, 7)}));
}

// Beside the plan's line, by as much as the nozzle is; along it nothing.
TEST(Comparison, ThePathDeviatesByItsDistanceFromThePlansLine) {
  for (const Vector3d& off : {Vector3d(0, 0.3, 0), Vector3d(0, 0, -0.4), Vector3d(0.2, 0, 0)}) {
    Job job;
    job.program.motions[4].position += off;
    job.program.motions[14].direction = {0, std::sin(0.2), std::cos(0.2)};
    const PathDeviation d = job.deviation();
    const double beside = off.tail<2>().norm();
    EXPECT_NEAR(d.mm, beside, 1e-9);
    if (beside > 0.0) {
      EXPECT_EQ(d.motion, 4u);
    }
    EXPECT_NEAR(d.rad, 0.2, 1e-9);
    job.program.tellsDirections = false;
    EXPECT_EQ(job.deviation().rad, 0.0);
  }
}

// A motion over points of a straight line is on it all the way, whatever came before.
TEST(Comparison, OverPointsInLineThePathDoesNotDeviate) {
  for (const bool extra : {false, true}) {
    Job job;
    job.program.motions.erase(job.program.motions.begin() + 5, job.program.motions.begin() + 7);
    if (extra) // something else, between the motions to points 3 and 4
      job.program.motions.insert(job.program.motions.begin() + 4, job.program.motions[4]);
    const ExecutedPath path = executeToolPoints(job.program, {});
    Alignment alignment;
    alignment.pointOf = {0, 1, 2, 3};
    if (extra)
      alignment.pointOf.push_back(kUnmatched);
    for (const std::size_t j : {4u, 7u, 8u, 9u, 10u, 11u, 12u, 13u, 14u, 15u})
      alignment.pointOf.push_back(j);
    alignment.leadsTo.assign(alignment.pointOf.size(), kUnmatched);
    ASSERT_EQ(alignment.pointOf.size(), job.program.motions.size());
    EXPECT_NEAR(pathDeviation(path, job.planned, job.trajectory, job.program, alignment, {}).mm,
                0.0, 1e-9);
  }
}

// A blend of radius r cuts a right corner by r/4 off both lines.
TEST(Comparison, ABlendDeviatesByTheCornerThatItCuts) {
  Job job;
  for (const double r : {0.2, 0.4}) {
    job.program.motions[7].blendMm = r;
    EXPECT_NEAR(job.deviation().mm, r / 4.0, 1e-9);
    EXPECT_TRUE(job.deviation().motion == 7 || job.deviation().motion == 8);
  }
}

// On a travel by joints the way is the arm's own affair, but not where it ends.
TEST(Comparison, OfTravelsByJointsOnlyTheEndCounts) {
  Job job;
  // Straight on the part by the text, while the plan's points before are elsewhere.
  job.planned.tip[8] += Vector3d(0, 0, 30);
  job.program.motions[8].position += Vector3d(0, 0, 30);
  EXPECT_NEAR(job.deviation().mm, 0.0, 1e-12);
  job.program.motions[9].position += Vector3d(0, 0.03, 0.04); // within the tolerance
  const PathDeviation d = job.deviation();
  EXPECT_NEAR(d.mm, 0.05, 1e-9);
  EXPECT_EQ(d.motion, 9u);
}

} // namespace
} // namespace voluta::replay
