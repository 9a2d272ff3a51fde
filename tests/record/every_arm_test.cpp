// A run of each cell's arm, recorded as its own joints, is compared as a whole: at a controller's
// cycle, at a slow recorder's, and by the points of trajectory.csv alone, whose transfers are
// single long motions.
#include "record/run_comparison.h"

#include "base/run_context.h"
#include "base/units.h"
#include "plan/trajectory.h"
#include "process/process.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>

namespace voluta::record {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using plan::MoveKind;
using robot::JointVector;

robot::Cell cellNamed(const std::string& id) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return robot::loadCell(id, process::loadProcess("fdm-1.0"),
                         {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}});
}

void add(plan::Trajectory& t, const JointVector& q, double seconds, MoveKind move, double mm3) {
  t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
  t.timeS.push_back((t.timeS.empty() ? 0.0 : t.timeS.back()) + seconds);
  t.move.push_back(move);
  t.waypoint.push_back(plan::kNoWaypoint);
  t.extrudedMm3.push_back((t.extrudedMm3.empty() ? 0.0 : t.extrudedMm3.back()) + mm3);
}

// Returns the joints for a tip, on the branch nearest to `near`; nullopt: out of reach.
std::optional<JointVector> jointsFor(const robot::Cell& cell, const Isometry3d& work_T_tool,
                                     const JointVector& near) {
  std::vector<JointVector> solutions;
  cell.inverse(work_T_tool, near, solutions);
  std::optional<JointVector> best;
  for (const JointVector& q : solutions)
    if (!best || (q - near).norm() < (*best - near).norm())
      best = q;
  return best;
}

// Home, one joint motion to three layers of a square of zigzags around `centre`, and home again;
// nullopt: the arm does not reach it.
std::optional<plan::Trajectory> squareAt(const robot::Cell& cell, const Isometry3d& centre) {
  constexpr double kSideMm = 24.0, kStepMm = 3.0, kBeadMmPerS = 20.0;
  plan::Trajectory t;
  t.dof = cell.dof();
  JointVector q = cell.home();
  add(t, q, 0.0, MoveKind::Joint, 0.0);
  const auto to = [&](const Vector3d& at, MoveKind move, double seconds) {
    Isometry3d tool = centre;
    tool.translation() += at;
    const auto next = jointsFor(cell, tool, q);
    if (!next || (t.pointCount() > 1 && (*next - q).cwiseAbs().maxCoeff() > 30.0))
      return false;
    add(t, *next, seconds, move, move == MoveKind::Print ? kStepMm : 0.0);
    q = *next;
    return true;
  };
  for (int layer = 0; layer < 3; ++layer) {
    const double z = 0.8 * layer;
    if (!to({0, 0, z + 5}, MoveKind::Joint, 2.0) || !to({0, 0, z}, MoveKind::Linear, 0.3))
      return std::nullopt;
    for (int line = 0; line < 8; ++line)
      for (double x = line == 0 ? kStepMm : 0.0; x <= kSideMm; x += kStepMm)
        if (!to({line % 2 == 0 ? x : kSideMm - x, kStepMm * line, z}, MoveKind::Print,
                kStepMm / kBeadMmPerS))
          return std::nullopt;
    if (!to({0, kStepMm * 7, z + 5}, MoveKind::Linear, 0.3))
      return std::nullopt;
  }
  add(t, cell.home(), 2.0, MoveKind::Joint, 0.0);
  return t;
}

plan::Trajectory squareOf(const robot::Cell& cell) {
  const Isometry3d home = cell.work_T_tool(cell.home());
  Isometry3d down = Isometry3d::Identity();
  down.linear() = Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  for (const Isometry3d& rotation : {home, down})
    for (const double height : {1.0, 30.0, 60.0, 100.0, 150.0})
      for (const double offset : {-12.0, 20.0, 60.0, 120.0, -120.0}) {
        Isometry3d centre = rotation;
        centre.translation() = Vector3d(offset, offset, height);
        if (auto t = squareAt(cell, centre))
          return *t;
      }
  ADD_FAILURE() << cell.id() << ": the square is nowhere in reach";
  return {};
}

void addRow(std::string& text, const robot::Cell& cell, double timeS, const JointVector& q) {
  text += fmt::format("{:.4f}", timeS);
  for (int k = 0; k < q.size(); ++k)
    text += fmt::format(",{:.6f}",
                        cell.limits()[static_cast<std::size_t>(k)].kind == robot::JointKind::Sliding
                            ? q[k]
                            : base::radiansToDegrees(q[k]));
  text += '\n';
}

// The record of the trajectory at a cycle; 0: its points alone.
std::string recordOf(const plan::Trajectory& t, const robot::Cell& cell, double cycleS) {
  std::string text = "time_s";
  for (int k = 0; k < t.dof; ++k)
    text += fmt::format(",j{}_{}", k + 1,
                        cell.limits()[static_cast<std::size_t>(k)].kind == robot::JointKind::Sliding
                            ? "mm"
                            : "deg");
  text += '\n';
  const auto jointsAt = [&](std::size_t i) -> JointVector {
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  };
  if (cycleS == 0.0) {
    for (std::size_t i = 0; i < t.pointCount(); ++i)
      addRow(text, cell, t.timeS[i], jointsAt(i));
    return text;
  }
  std::size_t i = 1;
  for (double timeS = 0.0; timeS <= t.timeS.back(); timeS += cycleS) {
    while (i + 1 < t.pointCount() && t.timeS[i] < timeS)
      ++i;
    const double share = (timeS - t.timeS[i - 1]) / (t.timeS[i] - t.timeS[i - 1]);
    addRow(text, cell, timeS, jointsAt(i - 1) + share * (jointsAt(i) - jointsAt(i - 1)));
  }
  return text;
}

class EveryArm : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryArm, IsComparedOverTheWholeJob) {
  const robot::Cell cell = cellNamed(GetParam());
  const plan::Trajectory t = squareOf(cell);
  ASSERT_GT(t.pointCount(), 0u);
  const base::RunContext ctx;
  const PlannedRun planned = plannedRun(t, cell, 0, ctx);
  for (const double cycleS : {0.0, 0.008, 0.1}) {
    const RecordedRun run = readRecord(recordOf(t, cell, cycleS), "record.csv", {cell});
    const RunComparison c = compareRun(run, planned, {}, ctx);
    EXPECT_GT(c.printedMm, 0.95 * c.beadsMm) << "cycle " << cycleS;
    EXPECT_EQ(c.missingMm, 0.0) << "cycle " << cycleS;
    EXPECT_LT(c.pathMeanMm, 0.15) << "cycle " << cycleS;
    EXPECT_NE(c.verdict(), RunVerdict::OtherJob);
    EXPECT_NE(c.verdict(), RunVerdict::Incomplete);
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, EveryArm, ::testing::ValuesIn([] {
                           setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
                           return robot::cellIds();
                         }()),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

} // namespace
} // namespace voluta::record
