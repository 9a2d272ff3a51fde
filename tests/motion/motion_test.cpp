#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/triangle_queries.h"
#include "motion/sample_plans.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

struct Planned {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Planned(plan::ToolPlan p, double plateRadius = 20.0, int threads = 2)
      : plan(std::move(p)), cell(robot::loadCell("ur5-fixed", process, test::disc(plateRadius))),
        part(plan, 0.45, {}),
        result(motion::MotionPlanner(plan, cell, process::Tooling(process), part, {})
                   .plan(base::RunContext(base::CancelToken(), threads))) {}
};

} // namespace

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Everything a finished motion promises, from its joints alone.
void expectSound(const Planned& p) {
  const plan::Trajectory& t = p.result.trajectory;
  ASSERT_GT(t.pointCount(), 2u);
  const auto q = [&](std::size_t i) {
    return robot::JointVector(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof));
  };
  EXPECT_LT((q(0) - p.cell.home()).norm(), 1e-12);
  EXPECT_LT((q(t.pointCount() - 1) - p.cell.home()).norm(), 1e-12);
  EXPECT_EQ(t.timeS.front(), 0.0);

  std::vector<int> printed(p.plan.waypointCount(), 0);
  double volume = 0.0;
  std::size_t last = plan::kNoWaypoint;
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    for (int j = 0; j < t.dof; ++j) {
      const auto& limit = p.cell.limits()[static_cast<std::size_t>(j)];
      EXPECT_GE(t.at(i)[j], limit.min);
      EXPECT_LE(t.at(i)[j], limit.max);
    }
    // The nozzle is where the plan wants it, along the wanted direction.
    if (t.waypoint[i] != plan::kNoWaypoint) {
      const Isometry3d pose = p.cell.work_T_tool(q(i));
      const std::size_t w = t.waypoint[i];
      EXPECT_LT((pose.translation() - p.plan.position[w]).norm(), 1e-6);
      EXPECT_LT((-pose.linear().col(2) - p.plan.direction[w]).norm(), 1e-6);
      ++printed[w];
    }
    if (i == 0)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    const robot::JointVector dq = (q(i) - q(i - 1)).cwiseAbs();
    ASSERT_GT(dt, 0.0);
    for (int j = 0; j < t.dof; ++j)
      EXPECT_LE(dq[j] / dt, p.cell.limits()[static_cast<std::size_t>(j)].velocity);
    if (t.move[i] == plan::MoveKind::Print) {
      EXPECT_LE(dq.maxCoeff(), 0.25); // no jump
      // The controller's motion: flange poses interpolated, half way.
      const Isometry3d a = p.cell.robot().kinematics->flange(q(i - 1)) * p.cell.flange_T_moved();
      const Isometry3d b = p.cell.robot().kinematics->flange(q(i)) * p.cell.flange_T_moved();
      Isometry3d half = Isometry3d::Identity();
      half.translation() = 0.5 * (a.translation() + b.translation());
      half.linear() = Eigen::Quaterniond(a.linear())
                          .slerp(0.5, Eigen::Quaterniond(b.linear()))
                          .toRotationMatrix();
      const Vector3d tip =
          p.cell.work_T_toolOfFlange(half * p.cell.flange_T_moved().inverse(), q(i)).translation();
      const Vector3d middle = 0.5 * (p.cell.work_T_tool(q(i - 1)).translation() +
                                     p.cell.work_T_tool(q(i)).translation());
      EXPECT_LT((tip - middle).norm(), 0.03);
      EXPECT_GE(t.extrudedMm3[i], volume);
    } else {
      EXPECT_EQ(t.extrudedMm3[i], volume);
    }
    volume = t.extrudedMm3[i];
    last = t.waypoint[i] == plan::kNoWaypoint ? last : t.waypoint[i];
  }
  std::size_t missing = 0;
  for (const int count : printed)
    missing += count == 0;
  EXPECT_EQ(missing, p.result.skipped.size());
  EXPECT_EQ(p.result.statistics.waypoints, printed.size() - missing);
}

double plannedVolume(const plan::ToolPlan& plan) {
  double volume = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      volume += (1.2 * 0.8 - (1 - base::kPi / 4) * 0.64) *
                (plan.position[i] - plan.position[i - 1]).norm();
  return volume;
}

TEST(Motion, Cylinder) {
  const Planned p(test::cylinder(15, 12));
  EXPECT_TRUE(p.result.findings.empty());
  expectSound(p);
  const double volume = plannedVolume(p.plan);
  EXPECT_NEAR(p.result.trajectory.extrudedMm3.back(), volume, 1e-5 * volume);
}

TEST(Motion, Slab) {
  const Planned p(test::slab(30, 3), 22);
  EXPECT_TRUE(p.result.findings.empty());
  expectSound(p);
}

// A wall that leans out by 50 degrees.
// Along the bead before the lift: back over one that ends, on along one that closes.
TEST(Motion, WipesAlongItsBeadBeforeItLifts) {
  for (const bool closed : {false, true}) {
    SCOPED_TRACE(closed);
    const plan::ToolPlan plan = closed ? test::cylinder(10.0, 3) : test::slab(12.0, 3);
    const process::Process process = process::loadProcess("fdm-1.0");
    const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20.0));
    const collision::GrowingPart part(plan, 0.45, {});
    motion::MotionOptions options;
    options.wipeMm = 3.5;
    const motion::MotionResult moved =
        motion::MotionPlanner(plan, cell, process::Tooling(process), part, options).plan({});
    const plan::Trajectory& t = moved.trajectory;
    EXPECT_TRUE(moved.skipped.empty());
    EXPECT_EQ(moved.statistics.collisions, 0u);
    EXPECT_NEAR(t.extrudedMm3.back(), plannedVolume(plan), 1e-6 * plannedVolume(plan));
    const auto tipAt = [&](std::size_t i) {
      return Vector3d(
          cell.work_T_tool(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof)).translation());
    };
    std::size_t wipes = 0, on = 0;
    for (std::size_t i = 1; i < t.pointCount(); ++i) {
      if (t.move[i] != plan::MoveKind::Wipe || t.move[i - 1] != plan::MoveKind::Print)
        continue;
      ++wipes;
      const plan::ToolPath& path = *plan::pathOf(plan, t.waypoint[i - 1]);
      double length = 0.0;
      std::size_t last = i;
      for (; t.move[last] == plan::MoveKind::Wipe; ++last) {
        length += (tipAt(last) - tipAt(last - 1)).norm();
        double away = 1e9;
        for (std::size_t w = path.first + 1; w < path.first + path.count; ++w)
          away = std::min(away, geometry::distanceToSegment(tipAt(last), plan.position[w - 1],
                                                            plan.position[w]));
        EXPECT_LT(away, 0.02);
        EXPECT_EQ(t.extrudedMm3[last], t.extrudedMm3[i - 1]);
      }
      EXPECT_NEAR(length, 3.5, 1e-6);
      on += (tipAt(last - 1) - plan.position[path.first + 3]).norm() < 1.0 ? 1 : 0;
    }
    // Between paths, and not where the print is at its end.
    EXPECT_EQ(wipes, plan.paths.size() - 1);
    EXPECT_EQ(on, closed ? wipes : 0u);
  }
}

TEST(Motion, LeaningWall) {
  const double lean = 0.87;
  const Planned p(test::rings(
                      14, [&](int l) { return 10 + 0.8 * std::sin(lean) * l; },
                      [&](int l) { return 0.8 + 0.8 * std::cos(lean) * l; },
                      [&](int l) { return std::min(lean, 0.15 * l); }),
                  9);
  EXPECT_TRUE(p.result.findings.empty());
  expectSound(p);
}

TEST(Motion, Hemisphere) {
  const Planned p(test::hemisphere(18, 35, 1.6, 0.3), 12);
  EXPECT_TRUE(p.result.findings.empty());
  expectSound(p);
}

// The motion again, looked at by a finer brush: no body in anything, at any time.
TEST(Motion, NothingMeetsOnAFinerLook) {
  const Planned p(test::hemisphere(14, 30, 1.4, 0.5), 10);
  const collision::CellCollision collision(p.cell, p.process);
  const plan::Trajectory& t = p.result.trajectory;
  std::size_t next = 0, checks = 0;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (t.waypoint[i] != plan::kNoWaypoint)
      next = t.waypoint[i];
    const Eigen::Map<const Eigen::VectorXd> a(t.at(i - 1), t.dof), b(t.at(i), t.dof);
    const int pieces = std::max(1, static_cast<int>((b - a).cwiseAbs().maxCoeff() / 0.003));
    for (int k = 0; k < pieces; ++k, ++checks) {
      const robot::JointVector q = a + (k + 0.37) / pieces * (b - a);
      collision::CellCollision::Frames frames;
      p.cell.framePoses(q, frames);
      const auto bodies = collision.bodies(frames, {0.0, 0.0, -0.1});
      EXPECT_FALSE(bodies) << i;
      EXPECT_FALSE(collision.bodiesAndPart(frames, p.part, next, {0.0, 0.0, 0.0})) << i;
      if (t.move[i] != plan::MoveKind::Print && t.waypoint[i] == plan::kNoWaypoint) {
        EXPECT_FALSE(collision.headTouchesPart(p.cell.work_T_tool(q), p.part, next, -0.1)) << i;
      }
    }
  }
  EXPECT_GT(checks, t.pointCount());
}

TEST(Motion, SameForAnyNumberOfThreads) {
  const auto plan = test::hemisphere(12, 30, 1.3, 0.5);
  const Planned one(plan, 10, 1), two(plan, 10, 2);
  EXPECT_EQ(one.result.trajectory.joints, two.result.trajectory.joints);
  EXPECT_EQ(one.result.trajectory.timeS, two.result.trajectory.timeS);
  EXPECT_EQ(one.result.trajectory.waypoint, two.result.trajectory.waypoint);
  EXPECT_EQ(one.result.statistics.minClearanceMm, two.result.statistics.minClearanceMm);
}

// Two rings each with one of two tools: a tool that may do less needs longer for its own rings.
TEST(Motion, EachToolMovesByItsProcess) {
  auto plan = test::cylinder(15, 4);
  process::Tool first, second;
  first.process = process::loadProcess("fdm-1.0");
  second.process = first.process;
  second.process.accelerationMmPerS2 = 0.2 * first.process.accelerationMmPerS2;
  second.process.travelSpeedMmPerS = 0.1 * first.process.travelSpeedMmPerS;
  const process::Tooling two({first, second});
  const robot::Cell cell = robot::loadCell("ur5-fixed", first.process, test::disc(20));
  const collision::GrowingPart part(plan, 0.45, {});
  const auto planned = [&](const process::Tooling& tooling) {
    return motion::MotionPlanner(plan, cell, tooling, part, {}).plan({}).trajectory;
  };
  const plan::Trajectory usual = planned(process::Tooling(first.process)), same = planned(two);
  EXPECT_EQ(same.timeS, usual.timeS); // no path uses the second one
  EXPECT_EQ(same.joints, usual.joints);
  EXPECT_TRUE(same.events.empty());

  plan.paths[2].tool = plan.paths[3].tool = 1;
  const plan::Trajectory slower = planned(two);
  ASSERT_EQ(slower.events.size(), 3u);
  EXPECT_EQ(slower.events[0].kind, plan::EventKind::Pause) << "the operator fits it first";
  const plan::TrajectoryEvent& change = slower.events[1];
  EXPECT_EQ(change.kind, plan::EventKind::ToolChange);
  EXPECT_EQ(slower.changeAfter(slower.events[0]), &change);
  EXPECT_EQ(slower.changeAfter(change), nullptr);
  EXPECT_EQ(slower.events[2].kind, plan::EventKind::Purge);
  EXPECT_DOUBLE_EQ(slower.events[2].volumeMm3, motion::MotionOptions{}.purge.changeMm3);
  for (const plan::TrajectoryEvent& event : slower.events)
    EXPECT_EQ(event.point, change.point);
  EXPECT_EQ(change.tool, 1);
  EXPECT_TRUE(slower.changesTool());
  EXPECT_FALSE(slower.changesTool(change.point));
  // It happens beside the part, between the second path and the third: nothing drips on the paths.
  const Eigen::VectorXd q =
      Eigen::Map<const Eigen::VectorXd>(slower.at(change.point - 1), slower.dof);
  EXPECT_TRUE(q.tail(5).isApprox(cell.home().tail(5)));
  const Vector3d tip = cell.work_T_tool(q).translation(),
                 down = cell.base_T_work(q).linear().transpose() * -Vector3d::UnitZ();
  for (const Vector3d& p : plan.position)
    EXPECT_GT((p - tip).cross(down).norm(), 20.0);
  EXPECT_EQ(plan::waypointAhead(slower, change.point), plan.paths[2].first);
  // Seconds from the first to the last waypoint of a path, and from there to the next path.
  const auto timesOf = [&](const plan::Trajectory& t, std::size_t path) {
    double begin = -1.0, end = 0.0, next = -1.0;
    for (std::size_t i = 0; i < t.pointCount(); ++i) {
      if (t.waypoint[i] == plan::kNoWaypoint)
        continue;
      const std::size_t w = t.waypoint[i], from = plan.paths[path].first;
      if (w == from)
        begin = t.timeS[i];
      if (w == from + plan.paths[path].count - 1)
        end = t.timeS[i];
      if (w == from + plan.paths[path].count && next < 0.0)
        next = t.timeS[i];
    }
    return std::pair(end - begin, next - end);
  };
  for (const std::size_t path : {0, 1, 2, 3}) {
    const auto [printUsual, travelUsual] = timesOf(usual, path);
    const auto [print, travel] = timesOf(slower, path);
    if (path < 2) {
      EXPECT_NEAR(print, printUsual, 1e-9) << path;
      if (path == 0) { // The transfer after the second path leads from tool to tool
        EXPECT_NEAR(travel, travelUsual, 1e-9);
      }
    } else {
      EXPECT_GT(print, printUsual + 0.05) << path;
    }
    if (path == 2) {
      EXPECT_GT(travel, 1.5 * travelUsual);
    }
  }
}

// Far out of reach: nothing is printed, and the finding names the place and the reason.
TEST(Motion, OutOfReachIsNamed) {
  auto plan = test::cylinder(15, 2);
  std::vector<Vector3d> far, up;
  for (int i = 0; i < 20; ++i) {
    far.emplace_back(i, 0, 1500);
    up.emplace_back(0, 0, 1);
  }
  const std::size_t first = plan.waypointCount();
  test::appendPath(plan, far, up, 2);
  process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20));
  const collision::GrowingPart part(plan, 2.0, {});
  const auto result =
      motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({});
  EXPECT_EQ(result.statistics.unreachable, 20u);
  ASSERT_EQ(result.skipped.size(), 20u);
  EXPECT_EQ(result.skipped.front(), first);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(plan::reportId(result.findings.front()), "unreachable");
  EXPECT_EQ(result.findings.front().count, 20u);
  ASSERT_TRUE(result.findings.front().where);
  EXPECT_NEAR(result.findings.front().where->z(), 1500, 1e-9);
}

// A nozzle sent below the plate.
TEST(Motion, HeadInThePlateIsNamed) {
  auto plan = test::cylinder(15, 2);
  for (std::size_t i = 20; i < 25; ++i)
    plan.position[i].z() = -2.0;
  process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20));
  const collision::GrowingPart part(plan, 0.5, {});
  const auto result =
      motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({});
  ASSERT_FALSE(result.findings.empty());
  EXPECT_EQ(plan::reportId(result.findings.front()), "collision");
  EXPECT_GE(result.statistics.collisions, 5u);
  EXPECT_FALSE(result.skipped.empty());
}

// A nozzle that would pass through printed beads at a few places of many: these are skipped with a
// finding, and nothing blocks.
TEST(Motion, FewCollidingWaypointsAreSkippedWithAFinding) {
  auto plan = test::cylinder(15, 12);
  const std::size_t at = plan.paths[6].first + 30;
  plan.direction[at] = Vector3d(1, 0, -0.2).normalized();
  process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20));
  const collision::GrowingPart part(plan, 0.45, {});
  const auto result =
      motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({});
  EXPECT_EQ(result.skipped, std::vector<std::size_t>{at});
  EXPECT_GT(result.statistics.leftOutFraction, 0.0);
  EXPECT_LT(result.statistics.leftOutFraction, 0.005);
  ASSERT_GE(result.findings.size(), 2u);
  for (const auto& f : result.findings)
    EXPECT_FALSE(f.blocking) << plan::englishReason(f);
  EXPECT_EQ(plan::reportId(result.findings.back()), "leftOut");
}

TEST(Motion, AvoidedWaypointsAreNotPrinted) {
  const auto plan = test::cylinder(15, 8);
  process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20));
  const collision::GrowingPart part(plan, 0.45, {});
  const std::vector<std::size_t> avoided{100, 101, 300};
  motion::MotionPlanner planner(plan, cell, process::Tooling(process), part, {});
  EXPECT_TRUE(planner.plan({}).skipped.empty());
  const auto result = planner.planWithout(avoided, {});
  EXPECT_EQ(result.skipped, avoided);
  EXPECT_EQ(plan::reportId(result.findings.front()), "collision");
  EXPECT_EQ(result.statistics.waypoints, plan.waypointCount() - avoided.size());

  // Those of earlier calls stay away.
  const auto less = planner.planWithout({500}, {});
  EXPECT_EQ(less.skipped, (std::vector<std::size_t>{100, 101, 300, 500}));
  EXPECT_EQ(less.statistics.splits, 3u);
}

TEST(Motion, EmptyPlanAndCancel) {
  process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20));
  const plan::ToolPlan none;
  const auto result = motion::MotionPlanner(none, cell, process::Tooling(process),
                                            collision::GrowingPart(none, 0.5, {}), {})
                          .plan({});
  EXPECT_EQ(result.trajectory.pointCount(), 1u);
  const base::CancelToken cancel;
  cancel.cancel();
  const auto plan = test::cylinder(15, 2);
  const collision::GrowingPart part(plan, 0.5, {});
  EXPECT_THROW(motion::MotionPlanner(plan, cell, process::Tooling(process), part, {})
                   .plan(base::RunContext(cancel, 2)),
               base::Cancelled);
}
