// Ways between beads of a ring that is half printed: their shape, and that they are clear.
#include "collision/growing_part.h"
#include "motion/motion_options.h"
#include "motion/transfers/transfer.h"

#include "base/run_context.h"
#include "base/units.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/sequence.h"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>

using namespace voluta;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using motion::Lift;
using motion::PrintedBounds;
using motion::RobotState;
using motion::Transfer;
using motion::TransferKind;
using motion::TransferPoint;
using plan::MoveKind;
using robot::JointVector;

namespace {

class Transfers : public testing::Test {
protected:
  plan::ToolPlan plan_ = test::cylinder(10.0, 10);
  process::Process process_ = process::loadProcess("fdm-1.0");
  robot::Cell cell_ = robot::loadCell("ur5-fixed", process_, test::disc(20.0));
  collision::CellCollision collision_{cell_, process_};
  collision::GrowingPart part_{plan_, 0.45, {}};
  motion::MotionOptions options_;
  motion::MotionScene scene_{plan_, cell_, collision_, part_, options_};
  motion::TransferPlanner planner_{scene_};
  RobotState home_ = motion::stateAt(cell_, cell_.home());

  // On a tip, leaning from upright about y: of the turns about the nozzle with which nothing meets,
  // the one with the joints next to `near`.
  RobotState state(const Vector3d& tip, double lean, const JointVector& near,
                   std::size_t before) const {
    RobotState best;
    double minimum = 1e9;
    collision::CellCollision::Frames frames;
    std::vector<JointVector> solutions;
    const Quaterniond tool =
        motion::carried(motion::uprightTool(), {std::sin(lean), 0.0, std::cos(lean)});
    for (int k = 0; k < 24; ++k) {
      const Quaterniond turned = motion::turned(tool, base::kTwoPi * k / 24);
      cell_.inverse(motion::toolPose(tip, turned), near, solutions);
      for (const JointVector& q : solutions) {
        cell_.framePoses(q, frames);
        const double away = (q - near).cwiseAbs().maxCoeff();
        if (away < minimum && !collision_.any(frames, part_, before, options_.printing)) {
          minimum = away;
          best = {tip, turned, q};
        }
      }
    }
    EXPECT_LT(minimum, 4.0);
    return best;
  }
  static Vector3d up(const RobotState& s, double mm) { return s.tip + mm * s.direction(); }

  // The pose of each point matches its joints, steps are as long as they may be, and the bodies and
  // the head stay clear of all that is printed.
  void expectSound(const RobotState& from, const std::vector<TransferPoint>& points,
                   std::size_t before) const {
    JointVector last = from.q;
    Vector3d lastTip = from.tip;
    Quaterniond lastTool = from.tool;
    collision::CellCollision::Frames frames;
    for (const TransferPoint& p : points) {
      const Eigen::Isometry3d pose = cell_.work_T_tool(p.at.q);
      EXPECT_LT((pose.translation() - p.at.tip).norm(), 1e-6);
      EXPECT_LT(motion::angleBetween(Quaterniond(pose.linear()), p.at.tool), 1e-6);
      const JointVector step = p.at.q - last;
      if (p.move == MoveKind::Joint) {
        EXPECT_LE(step.cwiseAbs().maxCoeff(), base::degreesToRadians(20.0) + 1e-9);
        EXPECT_EQ(p.peakDisplacement.size(), 0);
      } else {
        EXPECT_LE((p.at.tip - lastTip).norm(), 25.0 + 1e-9);
        ASSERT_EQ(p.peakDisplacement.size(), 6);
        const JointVector fastest = fastestBetween(last, lastTip, lastTool, p.at);
        for (int j = 0; j < 6; ++j) {
          EXPECT_LE(p.peakDisplacement[j], 1.01 * fastest[j] + 1e-6);
          EXPECT_GE(p.peakDisplacement[j], 0.8 * fastest[j] - 1e-3);
          EXPECT_GE(p.peakDisplacement[j], std::abs(step[j]) - 1e-9) << "no slower than its mean";
        }
      }
      for (int k = 1; k <= 20; ++k) {
        cell_.framePoses(last + k / 20.0 * step, frames);
        EXPECT_FALSE(collision_.bodies(frames, {1.0, 1.0, -0.1}));
        EXPECT_FALSE(collision_.bodiesAndPart(frames, part_, before, {1.0, 1.0, 0.0}));
        EXPECT_FALSE(collision_.headTouchesPart(cell_.work_T_tool(last + k / 20.0 * step), part_,
                                                before, -0.3));
      }
      last = p.at.q;
      lastTip = p.at.tip;
      lastTool = p.at.tool;
    }
  }
  // Of each joint: its greatest step of many, as if all were as long.
  JointVector fastestBetween(JointVector q, const Vector3d& tip, const Quaterniond& tool,
                             const RobotState& to) const {
    constexpr int kSteps = 100;
    JointVector peakDisplacement = JointVector::Zero(6);
    std::vector<JointVector> scratch;
    for (int k = 1; k <= kSteps; ++k) {
      const double t = k / static_cast<double>(kSteps);
      const JointVector last = q;
      EXPECT_TRUE(motion::solveNear(cell_, tip + t * (to.tip - tip), tool.slerp(t, to.tool), last,
                                    0.2, scratch, q));
      peakDisplacement = peakDisplacement.cwiseMax((q - last).cwiseAbs());
    }
    return kSteps * peakDisplacement;
  }
  static void expectAt(const RobotState& is, const RobotState& wanted) {
    EXPECT_LT((is.tip - wanted.tip).norm(), 1e-9);
    EXPECT_LT(motion::angleBetween(is.tool, wanted.tool), 1e-9);
    EXPECT_LT((is.q - wanted.q).norm(), 1e-9);
  }
};

} // namespace

// Up along the nozzle, straight over, down: by a millimetre for hops, else by the lift.
TEST_F(Transfers, AHopLiftsLittleAndATravelMore) {
  const std::size_t before = plan_.paths[5].first;
  const double z = 0.8 * 5;
  const RobotState from = state({10.0, 0.0, z}, 0.0, cell_.home(), before);
  for (const bool hop : {true, false}) {
    const RobotState to = hop ? state({10.0, 2.5, z}, 0.0, from.q, before)
                              : state({-9.0, 1.0, z}, 0.2, from.q, before);
    const auto transfer =
        planner_.plan(from, to, hop ? Lift::Hop : Lift::Usual, before, {{0, 0, 2}, 12.0}, 1, {});
    ASSERT_TRUE(transfer);
    EXPECT_EQ(transfer->kind, TransferKind::Straight);
    ASSERT_GE(transfer->points.size(), 3u);
    const double lift = hop ? options_.hopLiftMm : options_.liftMm;
    EXPECT_LT((transfer->points.front().at.tip - up(from, lift)).norm(), 1e-9);
    EXPECT_LT(motion::angleBetween(transfer->points.front().at.tool, from.tool), 1e-9);
    const RobotState& over = transfer->points[transfer->points.size() - 2].at;
    EXPECT_LT((over.tip - up(to, lift)).norm(), 1e-9);
    EXPECT_LT(motion::angleBetween(over.tool, to.tool), 1e-9);
    expectAt(transfer->points.back().at, to);
    // Between the stations on one line, turning with it.
    const Vector3d a = up(from, lift), b = up(to, lift);
    for (std::size_t k = 1; k + 2 < transfer->points.size(); ++k) {
      const double t = (transfer->points[k].at.tip - a).norm() / (b - a).norm();
      EXPECT_LT((transfer->points[k].at.tip - a - t * (b - a)).norm(), 1e-9);
      EXPECT_LT(motion::angleBetween(transfer->points[k].at.tool, from.tool.slerp(t, to.tool)),
                1e-9);
    }
    expectSound(from, transfer->points, before);
  }
}

// Over a ring in between, from beside it: by 2, 4, 10 or 20 mm, the first that is enough.
TEST(TransferLifts, AreNoHigherThanTheyHaveToBe) {
  struct Case {
    int layers; // of 0.8 mm
    double atMm, liftMm;
  };
  for (const Case& c : {Case{10, 7.2, 2.0}, {10, 5.2, 4.0}, {10, 1.0, 10.0}, {25, 4.0, 20.0}}) {
    SCOPED_TRACE(c.liftMm);
    const plan::ToolPlan plan = test::cylinder(10.0, c.layers);
    const process::Process process = process::loadProcess("fdm-1.0");
    const robot::Cell cell = robot::loadCell("ur5-fixed", process, test::disc(20.0));
    const collision::CellCollision collision(cell, process);
    const collision::GrowingPart part(plan, 0.45, {});
    const motion::MotionOptions options;
    const motion::MotionScene scene{plan, cell, collision, part, options};
    const std::size_t before = plan.waypointCount();
    // The first turn about the nozzle with which both are free.
    RobotState from, to;
    std::optional<Transfer> transfer;
    std::vector<JointVector> scratch;
    for (int k = 0; k < 24 && !transfer; ++k) {
      from.tip = {30.0, 0.0, c.atMm};
      to.tip = {-30.0, 3.0, c.atMm};
      from.tool = to.tool = motion::turned(motion::uprightTool(), base::kTwoPi * k / 24);
      if (!motion::solveNear(cell, from.tip, from.tool, cell.home(), 4.0, scratch, from.q) ||
          !motion::solveNear(cell, to.tip, to.tool, from.q, 1.0, scratch, to.q))
        continue;
      transfer = motion::TransferPlanner(scene).plan(from, to, Lift::Usual, before,
                                                     {{0, 0, 4}, 30.0}, 1, {});
      if (transfer && transfer->kind != TransferKind::Straight)
        transfer.reset();
    }
    ASSERT_TRUE(transfer);
    EXPECT_LT((transfer->points.front().at.tip - from.tip - Vector3d(0, 0, c.liftMm)).norm(), 1e-9);
    EXPECT_LT(
        (transfer->points[transfer->points.size() - 2].at.tip - to.tip - Vector3d(0, 0, c.liftMm))
            .norm(),
        1e-9);
  }
}

// Where directions lean apart by more than a quarter circle: out of the ball, and round it.
TEST_F(Transfers, AroundTheBallWhereDirectionsAreFarApart) {
  const Vector3d middle(0, 0, 4);
  const PrintedBounds ball{middle, 14.0};
  const std::size_t before = plan_.paths[9].first;
  const RobotState from = state({12.0, 0.0, 40.0}, 0.85, cell_.home(), before);
  const RobotState to = state({-12.0, 0.0, 40.0}, -0.85, from.q, before);
  const auto transfer = planner_.plan(from, to, Lift::Usual, before, ball, 1, {});
  ASSERT_TRUE(transfer);
  EXPECT_EQ(transfer->kind, TransferKind::Arc);
  expectAt(transfer->points.back().at, to);
  expectSound(from, transfer->points, before);
  // Out along the nozzle, then in pieces of ten degrees at most, no nearer than that except for the
  // first and the last one.
  const double lift = 10.0 * options_.liftMm;
  const Vector3d a = up(from, lift) - middle, b = up(to, lift) - middle;
  const double minimum = std::min(a.norm(), b.norm()), maximum = std::max(a.norm(), b.norm());
  const double half = base::degreesToRadians(5.0);
  const auto angleTo = [](const Vector3d& u, const Vector3d& v) {
    return std::acos(std::min(1.0, u.normalized().dot(v.normalized())));
  };
  EXPECT_LT((transfer->points.front().at.tip - up(from, lift)).norm(), 1e-9);
  EXPECT_LT((transfer->points[transfer->points.size() - 2].at.tip - up(to, lift)).norm(), 1e-9);
  for (std::size_t k = 0; k + 1 < transfer->points.size(); ++k) {
    const Vector3d at = transfer->points[k].at.tip - middle;
    const bool inner = std::min(angleTo(a, at), angleTo(b, at)) > 2.0 * half;
    EXPECT_GT(at.norm(), (inner ? minimum : minimum * std::cos(half)) - 1e-6);
    EXPECT_LT(at.norm(), maximum / std::cos(half) + 1e-6);
    EXPECT_NEAR(at.dot(a.cross(b).normalized()), 0.0, 1e-6) << "by the shortest way round";
    EXPECT_GE(at.dot(a.normalized() + b.normalized()), 0.0);
  }
}

// Down along the nozzle from where the ball around the part is left, from 50 mm at least.
TEST_F(Transfers, AnApproachComesDownFromOutsideTheBall) {
  const std::size_t before = plan_.paths[3].first + 1;
  for (const double lean : {0.0, 0.3}) {
    const RobotState start = state({10.0, 0.0, 2.4}, lean, cell_.home(), before);
    for (const double radius : {12.0, 55.0, 70.0}) {
      SCOPED_TRACE(radius);
      const PrintedBounds ball{{1.0, 2.0, 3.0}, radius};
      // |start + h d - centre| = radius + 5, by halving.
      double low = 0.0, high = 300.0;
      for (int k = 0; k < 60; ++k) {
        const double h = 0.5 * (low + high);
        ((up(start, h) - ball.centre).norm() < radius + 5.0 ? low : high) = h;
      }
      const double height = std::max(50.0, low);
      const auto transfer = planner_.approach(home_, start, before, ball, 1, {});
      ASSERT_TRUE(transfer);
      expectAt(transfer->points.back().at, start);
      expectSound(home_, transfer->points, before);
      std::size_t joints = 0; // they come first
      while (transfer->points[joints].move == MoveKind::Joint)
        ++joints;
      ASSERT_GT(joints, 0u);
      EXPECT_LT((transfer->points[joints - 1].at.tip - up(start, height)).norm(), 1e-6);
      for (std::size_t k = joints; k < transfer->points.size(); ++k) {
        EXPECT_EQ(transfer->points[k].move, MoveKind::Linear);
        const double above = (transfer->points[k].at.tip - start.tip).dot(start.direction());
        EXPECT_LT((transfer->points[k].at.tip - up(start, above)).norm(), 1e-9);
        EXPECT_LT(motion::angleBetween(transfer->points[k].at.tool, start.tool), 1e-9);
      }
      // Away again by the same way.
      const auto back = planner_.leave(start, home_, before, ball, 1, {});
      ASSERT_TRUE(back);
      ASSERT_EQ(back->points.size(), transfer->points.size());
      const std::size_t n = transfer->points.size();
      for (std::size_t k = 0; k < n; ++k) {
        EXPECT_EQ(back->points[k].move, transfer->points[n - 1 - k].move);
        expectAt(back->points[k].at, k + 1 == n ? home_ : transfer->points[n - 2 - k].at);
      }
    }
  }
}

// Back over the printed bead, or on where a ring closes; no further than the given length.
TEST_F(Transfers, WipeFollowsItsBeadForTheGivenLength) {
  const plan::ToolPath& path = plan_.paths[4];
  for (const bool closed : {true, false}) {
    motion::Run run;
    JointVector near = cell_.home();
    const std::size_t count = closed ? path.count : 30;
    for (std::size_t i = 0; i < count; ++i) {
      motion::RunPoint p;
      p.at = state(plan_.position[path.first + i], 0.0, near, path.first);
      near = p.at.q;
      run.points.push_back(p);
    }
    const double step = (run.points[1].at.tip - run.points[0].at.tip).norm();
    const std::size_t before = path.first + count;
    for (const double mm : {0.0, 0.4, 1.0, 3.7}) {
      const auto points = planner_.wipe(run, mm, before);
      double length = 0.0;
      Vector3d last = run.points.back().at.tip;
      for (const TransferPoint& p : points) {
        EXPECT_EQ(p.move, MoveKind::Wipe);
        length += (p.at.tip - last).norm();
        last = p.at.tip;
      }
      EXPECT_NEAR(length, mm, 1e-9);
      EXPECT_EQ(points.size(), static_cast<std::size_t>(std::ceil(mm / step)));
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        EXPECT_LT((points[k].at.tip - run.points[closed ? k + 1 : count - 2 - k].at.tip).norm(),
                  1e-9);
    }
    // All of it, and no more.
    motion::Run two;
    two.points = {run.points[0], run.points[1]};
    EXPECT_NEAR((planner_.wipe(two, 50.0, before).back().at.tip - run.points[0].at.tip).norm(), 0.0,
                1e-9);
    EXPECT_EQ(planner_.wipe(two, 50.0, before).size(), 1u);
  }
}
