// A rod that turns under the nozzle: the cell "lathe" and others made from it.
#include "base/error.h"
#include "base/files.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "helpers/temporary_folder.h"
#include "motion/external_axes.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "plan/finding_kinds.h"
#include "process/tooling.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using nlohmann::json;

namespace {

constexpr double kStep = base::kTwoPi / 3200.0;

// A winding at radius r about the rod from x0 on, `pitch` a turn, in steps of at most 10 degrees
// and 1 mm. `lean`: of the directions towards +x, rad.
void wind(plan::ToolPlan& plan, double r, double x0, double pitch, double turns, double lean = 0.0,
          int layer = 0) {
  const double step = std::min(base::kPi / 18.0, 1.0 / r);
  const int n = static_cast<int>(std::ceil(turns * base::kTwoPi / step));
  std::vector<Vector3d> points, directions;
  for (int i = 0; i <= n; ++i) {
    const double a = turns * base::kTwoPi * i / n;
    const Vector3d out(0, std::cos(a), std::sin(a));
    points.push_back(r * out + Vector3d(x0 + pitch * a / base::kTwoPi, 0, 0));
    directions.push_back(std::cos(lean) * out + std::sin(lean) * Vector3d::UnitX());
  }
  test::appendPath(plan, points, directions, layer);
  for (std::size_t i = plan.paths.back().first; i < plan.waypointCount(); ++i) {
    plan.widthMm[i] = 0.7F;
    plan.heightMm[i] = 0.25F;
  }
}

plan::ToolPlan winding(double r, double x0, double pitch, double turns, double lean = 0.0) {
  plan::ToolPlan plan;
  wind(plan, r, x0, pitch, turns, lean);
  return plan;
}

// A line along the rod.
void lay(plan::ToolPlan& plan, double r, double angle, double from, double to, int layer) {
  std::vector<Vector3d> points, directions;
  const Vector3d out(0, std::cos(angle), std::sin(angle));
  const int n = static_cast<int>(std::ceil(std::abs(to - from)));
  for (int i = 0; i <= n; ++i) {
    points.push_back(r * out + Vector3d(from + (to - from) * i / n, 0, 0));
    directions.push_back(out);
  }
  test::appendPath(plan, points, directions, layer);
}

struct Wound {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-0.35");
  robot::Cell cell;
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Wound(plan::ToolPlan p, const std::function<void(json&)>& edit = {}, int threads = 2)
      : plan(std::move(p)), cell(cellOf(process, edit)), part(plan, 0.35, {}),
        result(motion::MotionPlanner(plan, cell, process::Tooling(process), part, {})
                   .plan(base::RunContext(base::CancelToken(), threads))) {}

  static robot::Cell cellOf(const process::Process& process,
                            const std::function<void(json&)>& edit) {
    platform::PlatformSolid rod;
    rod.rod = platform::straightRod(5, 200);
    if (!edit)
      return robot::loadCell("lathe", process, rod);
    const std::filesystem::path from(VOLUTA_SOURCE_DIR "/resources/cells/lathe.json");
    json description = json::parse(base::readFile(from));
    edit(description);
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "lathe.json";
    std::ofstream(file) << description.dump();
    return robot::Cell::read(file, process, rod);
  }

  robot::JointVector q(std::size_t i) const {
    const plan::Trajectory& t = result.trajectory;
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  }
  double rod(std::size_t i) const { return result.trajectory.at(i)[6]; }
};

// Invariants of a finished motion on a rod, from its joints alone.
void expectSound(const Wound& w) {
  const plan::Trajectory& t = w.result.trajectory;
  ASSERT_EQ(t.dof, 7);
  ASSERT_GT(t.pointCount(), 2u);
  std::vector<int> printed(w.plan.waypointCount(), 0);
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const robot::JointVector q = w.q(i);
    for (int j = 0; j < 7; ++j) {
      EXPECT_GE(q[j], w.cell.limits()[static_cast<std::size_t>(j)].min);
      EXPECT_LE(q[j], w.cell.limits()[static_cast<std::size_t>(j)].max);
    }
    const double steps = q[6] / kStep;
    EXPECT_LT(std::abs(steps - std::round(steps)), 1e-6) << i;
    if (t.waypoint[i] != plan::kNoWaypoint) {
      ++printed[t.waypoint[i]];
      const Isometry3d pose = w.cell.work_T_tool(q);
      EXPECT_LT((pose.translation() - w.plan.position[t.waypoint[i]]).norm(), 1e-9);
      EXPECT_LT((pose.linear().col(2) + w.plan.direction[t.waypoint[i]]).norm(), 1e-9);
    }
    if (i == 0)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    ASSERT_GT(dt, 0.0);
    const robot::JointVector dq = (q - w.q(i - 1)).cwiseAbs();
    for (int j = 0; j < 7; ++j) // the rod's steps are not its speed
      EXPECT_LE(dq[j] - (j == 6 ? kStep : 0.0),
                dt * w.cell.limits()[static_cast<std::size_t>(j)].velocity + 1e-12);
    if (t.move[i] == plan::MoveKind::Print) {
      EXPECT_LE(dq.head(6).maxCoeff(), 0.25);
    }
  }
  const auto missing = std::count(printed.begin(), printed.end(), 0);
  EXPECT_EQ(static_cast<std::size_t>(missing), w.result.skipped.size());
  // It comes home, the rod by whole turns elsewhere where it runs on.
  const robot::JointVector end = w.q(t.pointCount() - 1);
  EXPECT_LT((end - w.cell.home()).head(6).norm(), 1e-12);
  EXPECT_LT(std::abs(end[6] - base::kTwoPi * std::round(end[6] / base::kTwoPi)), 1e-9);
}

// How far the nozzle is from straight down in the base, rad.
double tilt(const Wound& w, std::size_t i) {
  const Vector3d tool = (w.cell.base_T_work(w.q(i)) * w.cell.work_T_tool(w.q(i))).linear().col(2);
  return std::acos(std::clamp(-tool.z(), -1.0, 1.0));
}

} // namespace

TEST(Lathe, RodTurnsUnderANozzleThatPointsDown) {
  const Wound w(winding(3.75, -10, 0.65, 30));
  EXPECT_TRUE(w.result.findings.empty());
  EXPECT_EQ(w.result.statistics.splits, 0u);
  expectSound(w);
  const plan::Trajectory& t = w.result.trajectory;
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print) {
      EXPECT_LT(tilt(w, i), 0.5 * kStep + 1e-9);
      low = std::min(low, w.rod(i));
      high = std::max(high, w.rod(i));
    }
  EXPECT_NEAR(high - low, 30 * base::kTwoPi, 0.2);
}

// Where the axis begins, how far it can turn, and directions along the rod.
TEST(Lathe, UprightAngles) {
  const process::Process process = process::loadProcess("fdm-0.35");
  const robot::Cell cell = Wound::cellOf(process, [](json& j) {
    j["externalAxes"][0]["minDeg"] = -720;
    j["externalAxes"][0]["maxDeg"] = 720;
    j["externalAxes"][0]["end"] = "unwinds";
  });
  const plan::ToolPlan plan = winding(3.75, 0, 0.65, 10);
  const std::size_t n = plan.waypointCount();
  // Up is z at 0: the winding begins at y, 90 degrees on, and turns the rod back.
  const auto all = motion::uprightAngles(plan, cell, 0, 20, 0.1);
  ASSERT_EQ(all.size(), 20u);
  EXPECT_NEAR(all.front(), base::kPi / 2, 1e-12);
  for (std::size_t i = 1; i < all.size(); ++i)
    EXPECT_NEAR(all[i] - all[i - 1], -base::kPi / 18, 1e-3);
  EXPECT_NEAR(motion::uprightAngles(plan, cell, 0, 20, 7.0).front(), base::kPi / 2 + base::kTwoPi,
              1e-12);
  EXPECT_NEAR(motion::uprightAngles(plan, cell, 0, 20, -9.0).front(), base::kPi / 2 - base::kTwoPi,
              1e-12);
  // As far as the limits are from the start that allows most.
  const auto furthest = motion::uprightAngles(plan, cell, 0, n, 0.0);
  EXPECT_NEAR(furthest.front(), base::kPi / 2 + base::kTwoPi, 1e-12);
  EXPECT_LT(furthest.size(), n);
  EXPECT_LT(furthest.back(), -2 * base::kTwoPi + 1.01 * base::kPi / 18);
  EXPECT_GE(furthest.back(), -2 * base::kTwoPi);

  plan::ToolPlan along;
  test::appendPath(along, {{0, 0, 5}, {1, 0, 5}, {2, 0, 5}},
                   {Vector3d(0, 0.1, 1), Vector3d::UnitX(), Vector3d(0, 0, 1)}, 0);
  const auto kept = motion::uprightAngles(along, cell, 0, 3, 0.0);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_NEAR(kept[0], std::atan(0.1), 1e-12);
  EXPECT_EQ(kept[1], kept[0]);
  EXPECT_NEAR(kept[2], 0.0, 1e-12);
}

TEST(Lathe, RodRestsAtTheNearestWholeTurnWhereItRunsOn) {
  const process::Process process = process::loadProcess("fdm-0.35");
  const robot::Cell on = Wound::cellOf(process, {});
  const robot::Cell back =
      Wound::cellOf(process, [](json& j) { j["externalAxes"][0]["end"] = "unwinds"; });
  robot::JointVector q = on.home();
  q[2] += 0.3;
  q[6] = 7.6 * base::kTwoPi;
  EXPECT_NEAR(motion::homeAfter(on, q)[6], 8 * base::kTwoPi, 1e-9);
  EXPECT_EQ(motion::homeAfter(on, q).head(6), on.home().head(6));
  EXPECT_EQ(motion::homeAfter(back, q), back.home());
}

// The beads that it lays and the time that takes are those of the plan.
TEST(Lathe, PrintsAtThePlansSpeed) {
  const Wound w(winding(3.75, -10, 0.65, 30));
  const plan::Trajectory& t = w.result.trajectory;
  double length = 0.0, first = -1.0, last = 0.0;
  for (std::size_t i = 1; i < w.plan.waypointCount(); ++i)
    length += (w.plan.position[i] - w.plan.position[i - 1]).norm();
  for (std::size_t i = 1; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print) {
      first = first < 0.0 ? t.timeS[i - 1] : first;
      last = t.timeS[i];
    }
  EXPECT_GE(last - first, length / 20.0);
  EXPECT_LE(last - first, 1.02 * length / 20.0 + 0.2);
  const double section = 0.7 * 0.25 - (1 - base::kPi / 4) * 0.25 * 0.25;
  EXPECT_NEAR(t.extrudedMm3.back(), section * length, 1e-4 * section * length);
}

// Ramps are those of nozzle and rod, not of the rod's turning as if it were way. r 2.75: 20 mm/s
// are 7.3 rad/s.
TEST(Lathe, StartsWithoutDelay) {
  const Wound w(winding(2.75, -5, 0.65, 6));
  ASSERT_TRUE(w.result.findings.empty());
  const plan::Trajectory& t = w.result.trajectory;
  const double byNozzle = 20.0 / w.process.accelerationMmPerS2;
  const double byRod = 20.0 / 2.75 / (0.9 * w.cell.limits()[6].acceleration);
  double start = -1.0;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (t.move[i] != plan::MoveKind::Print)
      continue;
    if (start < 0.0)
      start = t.timeS[i - 1];
    const double speed =
        (w.plan.position[t.waypoint[i]] - w.plan.position[t.waypoint[i] - 1]).norm() /
        (t.timeS[i] - t.timeS[i - 1]);
    if (speed > 0.95 * 20.0) {
      EXPECT_LT(t.timeS[i - 1] - start, std::max(byNozzle, byRod) + 0.05); // two waypoints
      return;
    }
  }
  FAIL() << "never at speed";
}

// A slow rod: the nozzle waits for it.
TEST(Lathe, KeepsTheRodsOwnLimits) {
  const Wound w(winding(2.75, -5, 0.65, 6), [](json& cell) {
    cell["externalAxes"][0]["velocityDegPerS"] = 180;
    cell["externalAxes"][0]["accelerationDegPerS2"] = 600;
  });
  ASSERT_TRUE(w.result.findings.empty());
  expectSound(w);
  const plan::Trajectory& t = w.result.trajectory;
  double maximum = 0.0;
  for (std::size_t i = 1; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print)
      maximum = std::max(maximum, (std::abs(w.rod(i) - w.rod(i - 1)) - kStep) /
                                      (t.timeS[i] - t.timeS[i - 1]));
  EXPECT_LE(maximum, base::degreesToRadians(180) + 1e-9);
  EXPECT_GT(maximum, 0.8 * base::degreesToRadians(180));
  // Of the angle that the steps follow: the direction's.
  double velocity = 0.0, last = 0.0;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (t.move[i] != plan::MoveKind::Print)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    const double rotation = std::acos(std::clamp(
        w.plan.direction[t.waypoint[i]].dot(w.plan.direction[t.waypoint[i] - 1]), -1.0, 1.0));
    EXPECT_LE(std::abs(rotation / dt - velocity), 0.5 * (dt + last) * base::degreesToRadians(600));
    velocity = rotation / dt;
    last = dt;
  }
}

TEST(Lathe, RoundingAtTheLargestRadiusMovesTheRodAloneNotTheTip) {
  const Wound w(winding(49.75, -2, 0.65, 2));
  EXPECT_TRUE(w.result.findings.empty());
  expectSound(w);
}

// Directions that lean along the rod: round the cone they come back, and so does the arm.
TEST(Lathe, LeaningDirectionsDoNotWindTheArmUp) {
  const Wound w(winding(5, -5, 0.3, 30, 0.3));
  EXPECT_TRUE(w.result.findings.empty());
  expectSound(w);
  const plan::Trajectory& t = w.result.trajectory;
  std::vector<double> distance(6, 0.0);
  for (std::size_t i = 1; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print)
      for (std::size_t j = 0; j < 6; ++j)
        distance[j] += t.at(i)[j] - t.at(i - 1)[j];
  for (const double joint : distance)
    EXPECT_LT(std::abs(joint), 0.5);
}

// 100 turns on an axis of 4: the path is printed in pieces, none of it lost.
TEST(Lathe, AnAxisThatEndsIsUnwound) {
  const Wound w(winding(3.75, -20, 0.4, 100), [](json& cell) {
    cell["externalAxes"][0]["minDeg"] = -720;
    cell["externalAxes"][0]["maxDeg"] = 720;
    cell["externalAxes"][0]["end"] = "unwinds";
  });
  EXPECT_TRUE(w.result.findings.empty());
  EXPECT_TRUE(w.result.skipped.empty());
  EXPECT_EQ(w.result.statistics.waypoints, w.plan.waypointCount());
  // 4 turns, and the end of a run is not often a limit: 3 to 4 a run.
  EXPECT_GE(w.result.statistics.splits, 24u);
  EXPECT_LE(w.result.statistics.splits, 34u);
  expectSound(w);
  EXPECT_EQ(w.rod(w.result.trajectory.pointCount() - 1), 0.0);
}

// Lines along the rod at any angle: the rod comes round the short way.
TEST(Lathe, BetweenPathsTheRodTurnsTheShortWay) {
  plan::ToolPlan plan;
  for (int i = 0; i < 12; ++i)
    lay(plan, 2.75, 2.6 * i, i % 2 ? 10 : -10, i % 2 ? -10 : 10, i);
  const Wound w(plan);
  EXPECT_TRUE(w.result.findings.empty());
  expectSound(w);
  const plan::Trajectory& t = w.result.trajectory;
  double last = 0.0;
  for (std::size_t i = 0; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print) {
      EXPECT_LE(std::abs(w.rod(i) - last), base::kPi + kStep);
      last = w.rod(i);
    }
}

// A beam over the rod, where a head that points straight down would be.
TEST(Lathe, RodIsTurnedOnWhereTheUprightNozzleMeetsSomething) {
  const auto beam = [](json& cell) {
    cell["obstacles"].push_back(json::parse(
        R"({"name": "beam", "shapes": [{"box": {"pose": {"xyzMm": [425, 0, 460]}, "sizeMm": [20, 80, 100]}}]})"));
  };
  const Wound w(winding(3.75, -2, 0.65, 6), beam);
  EXPECT_TRUE(w.result.findings.empty());
  EXPECT_TRUE(w.result.skipped.empty());
  expectSound(w);
  const plan::Trajectory& t = w.result.trajectory;
  for (std::size_t i = 0; i < t.pointCount(); ++i)
    if (t.waypoint[i] != plan::kNoWaypoint) {
      EXPECT_GT(tilt(w, i), base::degreesToRadians(5));
      EXPECT_LT(tilt(w, i), base::degreesToRadians(31));
    }
}

// A steady rest that the part turns in, and grows into.
TEST(Lathe, PartMustNotGrowIntoTheRestOfTheRod) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 24; ++layer)
    wind(plan, 2.75 + 0.25 * layer, -3, 0.65, 9, 0.0, layer);
  const Wound w(plan, [](json& cell) {
    cell["obstacles"].push_back(json::parse(
        R"({"name": "rest", "shapes": [{"box": {"pose": {"xyzMm": [400, 0, 335]}, "sizeMm": [20, 10, 10]}}]})"));
    cell["neverMeet"].push_back({{"pair", {"rest", "platform"}}, {"why", "it holds the rod"}});
  });
  ASSERT_FALSE(w.result.findings.empty());
  const plan::Finding& finding = w.result.findings.front();
  EXPECT_EQ(voluta::plan::reportId(finding), "collision");
  EXPECT_NE(voluta::plan::englishReason(finding).find("rest would collide with printed part"),
            std::string::npos)
      << voluta::plan::englishReason(finding);
  ASSERT_TRUE(finding.where);
  // The rest's top is 10 mm below the axis, 2 mm are kept: nothing beyond 8.25 mm is printed.
  EXPECT_GT(w.result.statistics.waypoints, 0u);
  for (std::size_t i = 0; i < w.result.trajectory.pointCount(); ++i)
    if (w.result.trajectory.move[i] == plan::MoveKind::Print) {
      EXPECT_LT(w.plan.position[w.result.trajectory.waypoint[i]].tail<2>().norm(), 8.6);
    }
}

TEST(Lathe, WaypointsBeyondTheCellsRodAreNamed) {
  plan::ToolPlan plan = winding(3.75, -2, 0.65, 3);
  const std::size_t first = plan.waypointCount();
  wind(plan, 50.5, 40, 0.65, 0.1, 0.0, 1);
  lay(plan, 2.75, 0.0, 100.5, 101.5, 2);
  const Wound w(plan);
  ASSERT_EQ(w.result.findings.size(), 1u);
  const plan::Finding& finding = w.result.findings.front();
  EXPECT_EQ(voluta::plan::reportId(finding), "beyondRod");
  EXPECT_NE(
      voluta::plan::englishReason(finding).find("50 mm from its axis and 100 mm from its middle"),
      std::string::npos);
  EXPECT_TRUE(finding.where);
  EXPECT_EQ(finding.count, plan.waypointCount() - first);
  EXPECT_EQ(w.result.statistics.unreachable, plan.waypointCount() - first);
  ASSERT_FALSE(w.result.skipped.empty());
  EXPECT_EQ(w.result.skipped.front(), first);
  EXPECT_EQ(w.result.skipped.size(), plan.waypointCount() - first);
}

TEST(Lathe, SameForAnyNumberOfThreads) {
  plan::ToolPlan plan = winding(2.75, -5, 0.65, 15);
  for (int i = 0; i < 6; ++i)
    lay(plan, 3.0, 0.24 * i, i % 2 ? 5 : -5, i % 2 ? -5 : 5, 1);
  const Wound one(plan, {}, 1), two(plan, {}, 2);
  EXPECT_EQ(one.result.trajectory.joints, two.result.trajectory.joints);
  EXPECT_EQ(one.result.trajectory.timeS, two.result.trajectory.timeS);
  EXPECT_EQ(one.result.statistics.minClearanceMm, two.result.statistics.minClearanceMm);
}

// The motion again, looked at by a finer brush.
TEST(Lathe, NothingMeetsOnAFinerLook) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 4; ++layer) {
    wind(plan, 2.75 + 0.5 * layer, -5, 0.65, 15, 0.0, 2 * layer);
    for (int i = 0; i < 5; ++i)
      lay(plan, 3.0 + 0.5 * layer, 1.3 * i, i % 2 ? 5 : -5, i % 2 ? -5 : 5, 2 * layer + 1);
  }
  const Wound w(plan);
  EXPECT_TRUE(w.result.findings.empty());
  const collision::CellCollision collision(w.cell, w.process);
  const plan::Trajectory& t = w.result.trajectory;
  std::size_t next = 0;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (t.waypoint[i] != plan::kNoWaypoint)
      next = t.waypoint[i];
    const robot::JointVector a = w.q(i - 1), b = w.q(i);
    const int pieces = std::max(1, static_cast<int>((b - a).cwiseAbs().maxCoeff() / 0.02));
    for (int k = 0; k < pieces; ++k) {
      const robot::JointVector q = a + (k + 0.37) / pieces * (b - a);
      collision::CellCollision::Frames frames;
      w.cell.framePoses(q, frames);
      EXPECT_FALSE(collision.bodies(frames, {0.0, 0.0, -0.1})) << i;
      EXPECT_FALSE(collision.bodiesAndPart(frames, w.part, next, {0.0, 0.0, 0.0})) << i;
      if (t.move[i] == plan::MoveKind::Joint && t.waypoint[i] == plan::kNoWaypoint) {
        EXPECT_FALSE(collision.headTouchesPart(w.cell.work_T_tool(q), w.part, next, -0.1)) << i;
      }
    }
  }
}
