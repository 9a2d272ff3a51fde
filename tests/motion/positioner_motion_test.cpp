// A plate on axes that tilt and turn: the cell "irb1200-irbp".
#include "base/run_context.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/axis_schedule.h"
#include "motion/check.h"
#include "motion/external_axes.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/sample_plans.h"
#include "process/tooling.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

platform::PlatformSolid disc() {
  platform::PlatformSolid plate;
  for (int i = 0; i < 32; ++i)
    plate.polygon.emplace_back(175 * std::cos(base::kTwoPi * i / 32),
                               175 * std::sin(base::kTwoPi * i / 32));
  return plate;
}

struct Printed {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell = robot::loadCell("irb1200-irbp", process, disc());
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Printed(plan::ToolPlan p, int threads = 2)
      : plan(std::move(p)), part(plan, 1.0, {}),
        result(motion::MotionPlanner(plan, cell, process::Tooling(process), part, {})
                   .plan(base::RunContext(base::CancelToken(), threads))) {}

  JointVector q(std::size_t i) const {
    const plan::Trajectory& t = result.trajectory;
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  }
  // Of the nozzle from straight down in the base, rad.
  double lean(std::size_t i) const {
    const Vector3d tool = (cell.base_T_work(q(i)) * cell.work_T_tool(q(i))).linear().col(2);
    return std::acos(std::clamp(-tool.z(), -1.0, 1.0));
  }
};

// Lines above the plate's middle, their directions leaning towards azimuth, each on the one before.
plan::ToolPlan leaning(double lean, double azimuth, int lines = 4) {
  plan::ToolPlan plan;
  const Vector3d d(std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth),
                   std::cos(lean));
  const Vector3d along(-std::sin(azimuth), std::cos(azimuth), 0.0);
  for (int l = 0; l < lines; ++l) {
    std::vector<Vector3d> points;
    for (int i = 0; i <= 30; ++i)
      points.push_back(Vector3d(0, 0, 60) + (i - 15.0) * along + 0.8 * l * d);
    test::appendPath(plan, points, std::vector<Vector3d>(points.size(), d), l);
  }
  return plan;
}

void expectSound(const Printed& p) {
  const plan::Trajectory& t = p.result.trajectory;
  ASSERT_EQ(t.dof, 8);
  std::vector<int> printed(p.plan.waypointCount(), 0);
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const JointVector q = p.q(i);
    for (int j = 0; j < 8; ++j) {
      EXPECT_GE(q[j], p.cell.limits()[static_cast<std::size_t>(j)].min);
      EXPECT_LE(q[j], p.cell.limits()[static_cast<std::size_t>(j)].max);
    }
    if (t.waypoint[i] != plan::kNoWaypoint) {
      ++printed[t.waypoint[i]];
      const Isometry3d pose = p.cell.work_T_tool(q);
      EXPECT_LT((pose.translation() - p.plan.position[t.waypoint[i]]).norm(), 1e-8);
      EXPECT_LT((pose.linear().col(2) + p.plan.direction[t.waypoint[i]]).norm(), 1e-8);
    }
    if (i == 0)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    ASSERT_GT(dt, 0.0);
    const JointVector dq = (q - p.q(i - 1)).cwiseAbs();
    for (int j = 0; j < 8; ++j)
      EXPECT_LE(dq[j], dt * p.cell.limits()[static_cast<std::size_t>(j)].velocity + 1e-12);
  }
  EXPECT_EQ(std::count(printed.begin(), printed.end(), 0),
            static_cast<std::ptrdiff_t>(p.result.skipped.size()));
  EXPECT_LT((p.q(t.pointCount() - 1) - p.cell.home()).norm(), 1e-12);
}

} // namespace

TEST(Positioner, StaysWhereItIsWhileTheNozzleLeansLittle) {
  const Printed p(leaning(base::degreesToRadians(15), 0.4));
  expectSound(p);
  EXPECT_TRUE(p.result.skipped.empty());
  for (std::size_t i = 0; i < p.result.trajectory.pointCount(); ++i)
    EXPECT_EQ(p.q(i).tail(2).norm(), 0.0);
}

// A nozzle straight down to a horizontal direction: the plate is tilted to it, whatever the side.
TEST(Positioner, TiltsThePlateToDirectionsThatLean) {
  for (const double azimuth : {0.4, 2.5, 4.4}) {
    const Printed p(leaning(base::degreesToRadians(80), azimuth));
    expectSound(p);
    EXPECT_TRUE(p.result.skipped.empty()) << p.result.skipped.size() << " at " << azimuth;
    for (std::size_t i = 0; i < p.result.trajectory.pointCount(); ++i)
      if (p.result.trajectory.move[i] == plan::MoveKind::Print) {
        EXPECT_LE(p.lean(i), base::degreesToRadians(36));
      }
  }
}

TEST(Positioner, IsTheSameForAnyNumberOfThreads) {
  const Printed one(leaning(1.2, 1.0, 2), 1), two(leaning(1.2, 1.0, 2), 2);
  EXPECT_EQ(one.result.trajectory.joints, two.result.trajectory.joints);
  EXPECT_EQ(one.result.trajectory.timeS, two.result.trajectory.timeS);
}

// The work frame by the axes' own chain: base_T_work without the first axis' place.
TEST(Positioner, AxesMoveDirectionsAndPointsAsTheCellDoes) {
  const robot::Cell cell = robot::loadCell("irb1200-irbp", process::loadProcess("fdm-1.0"), disc());
  JointVector q = cell.home();
  q.tail(2) << 0.7, -2.1;
  const Isometry3d base_T_first = cell.externalAxes().front().before_T_axis;
  const JointVector axes = motion::axesOf(cell, q);
  const Vector3d p(30, -20, 50), d = Vector3d(1, 2, 3).normalized();
  EXPECT_LT((base_T_first * motion::movedByAxes(cell, p, axes) - cell.base_T_work(q) * p).norm(),
            1e-10);
  EXPECT_LT((base_T_first.linear() * motion::turnedByAxes(cell, d, axes) -
             cell.base_T_work(q).linear() * d)
                .norm(),
            1e-12);
  EXPECT_LT((motion::axesRotation(cell, axes) * d - motion::turnedByAxes(cell, d, axes)).norm(),
            1e-12);
}

// The arm rests beside the plate, which tilts into it between two points that are clear.
TEST(Positioner, APlateThatTiltsIntoTheArmIsFound) {
  const Printed p(leaning(0.0, 0.0, 1));
  const collision::CellCollision collision(p.cell, p.process);
  const motion::MotionOptions options;
  const motion::MotionScene scene{p.plan, p.cell,  collision,
                                  p.part, options, motion::leversOf(p.plan, p.cell)};
  plan::Trajectory t;
  t.dof = 8;
  Isometry3d beside = Isometry3d::Identity(); // right of the tilt axis, above the level plate
  beside.linear() = Vector3d(1, -1, -1).asDiagonal();
  beside.translation() = Vector3d(0, 120, 60);
  std::vector<JointVector> solutions;
  p.cell.inverse(beside, p.cell.home(), solutions);
  ASSERT_FALSE(solutions.empty());
  const auto add = [&](double tilt) {
    JointVector q = solutions.front();
    q[6] = tilt;
    t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
    t.timeS.push_back(static_cast<double>(t.timeS.size()));
    t.move.push_back(plan::MoveKind::Joint);
    t.waypoint.push_back(plan::kNoWaypoint);
    t.extrudedMm3.push_back(0.0);
  };
  add(0.0);
  add(base::degreesToRadians(-10));
  const std::vector<std::size_t> before(p.plan.waypointCount(), 0);
  EXPECT_TRUE(motion::checkTrajectory(t, scene, before, 100.0, {}).collisions.empty());
  add(base::degreesToRadians(170)); // through the nozzle
  const auto met = motion::checkTrajectory(t, scene, before, 100.0, {}).collisions;
  ASSERT_EQ(met.size(), 1u);
  EXPECT_EQ(met.front().point, 2u);
}
