// Sliding axes: of the plate in the cell "kr10-r1100-slide", of the arm in "kr10-r1100-track".
#include "base/data_files.h"
#include "base/files.h"
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/external_axes.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/sample_plans.h"
#include "process/tooling.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr Eigen::Index kSlide = 6;

struct Printed {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  collision::GrowingPart part;
  motion::MotionResult result;

  explicit Printed(plan::ToolPlan p, const std::string& id = "kr10-r1100-slide")
      : plan(std::move(p)), cell(robot::loadCell(id, process, plate())), part(plan, 4.0, {}),
        result(motion::MotionPlanner(plan, cell, process::Tooling(process), part, {}).plan({})) {}

  static platform::PlatformSolid plate() {
    platform::PlatformSolid solid;
    solid.polygon = {{-100, -1100}, {100, -1100}, {100, 1100}, {-100, 1100}};
    return solid;
  }
  JointVector q(std::size_t i) const {
    const plan::Trajectory& t = result.trajectory;
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  }
};

// Along the slide, from -half to half, there and back.
plan::ToolPlan lines(double half) {
  plan::ToolPlan plan;
  for (int l = 0; l < 2; ++l) {
    std::vector<Vector3d> points;
    const int steps = static_cast<int>(half);
    for (int i = -steps; i <= steps; ++i)
      points.emplace_back(0.0, l == 0 ? i : -i, 0.8 * (l + 1));
    test::appendPath(plan, points, std::vector<Vector3d>(points.size(), Vector3d::UnitZ()), l);
  }
  return plan;
}

// Checks every point of the trajectory; returns its range along the slide.
std::pair<double, double> checkedWay(const Printed& p) {
  EXPECT_TRUE(p.result.skipped.empty()) << p.result.skipped.size();
  const plan::Trajectory& t = p.result.trajectory;
  EXPECT_EQ(t.dof, 7);
  double low = 0.0, high = 0.0;
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    const JointVector q = p.q(i);
    low = std::min(low, q[kSlide]);
    high = std::max(high, q[kSlide]);
    for (Eigen::Index j = 0; j < 7; ++j) {
      EXPECT_GE(q[j], p.cell.limits()[static_cast<std::size_t>(j)].min);
      EXPECT_LE(q[j], p.cell.limits()[static_cast<std::size_t>(j)].max);
    }
    if (t.waypoint[i] != plan::kNoWaypoint) {
      const Isometry3d pose = p.cell.work_T_tool(q);
      EXPECT_LT((pose.translation() - p.plan.position[t.waypoint[i]]).norm(), 1e-8);
    }
    if (i == 0)
      continue;
    const double dt = t.timeS[i] - t.timeS[i - 1];
    for (Eigen::Index j = 0; j < 7; ++j)
      EXPECT_LE(std::abs(q[j] - p.q(i - 1)[j]),
                dt * p.cell.limits()[static_cast<std::size_t>(j)].velocity + 1e-9);
  }
  EXPECT_LT((p.q(t.pointCount() - 1) - p.cell.home()).norm(), 1e-12);
  return {low, high};
}

} // namespace

// Longer than the arm reaches: the plate slides along under it.
TEST(Slide, BringsTheEndsOfALongPart) {
  const auto [low, high] = checkedWay(Printed(lines(1050.0)));
  EXPECT_LT(low, -200.0);
  EXPECT_GT(high, 200.0);
}

// The arm rides along past it: towards the end that it prints, as far as the plate would have come.
TEST(Slide, TheArmRidesToTheEndsOfALongPart) {
  const Printed p(lines(1050.0), "kr10-r1100-track");
  const auto [low, high] = checkedWay(p);
  EXPECT_LT(low, -200.0);
  EXPECT_GT(high, 200.0);
  const plan::Trajectory& t = p.result.trajectory;
  for (std::size_t i = 0; i < t.pointCount(); ++i)
    if (t.waypoint[i] != plan::kNoWaypoint) {
      const double y = p.plan.position[t.waypoint[i]].y();
      // The arm's place in the world lets it reach the tip less than a metre aside.
      EXPECT_LT(std::abs(y - p.q(i)[kSlide]), 1000.0);
    }
}

// A fixed body blocks the carriage: a post where the arm would pass with it.
TEST(Slide, APostBesideTheTrackStopsTheCarriage) {
  Printed free(lines(1050.0), "kr10-r1100-track");
  nlohmann::json description =
      nlohmann::json::parse(base::readFile(base::resourceFolder() / "cells/kr10-r1100-track.json"));
  description["obstacles"].push_back(
      {{"name", "post"},
       {"shapes", {{{"box", {{"pose", {{"xyzMm", {0, 600, 0}}}}, {"sizeMm", {100, 40, 300}}}}}}}});
  const auto post = [&](const JointVector& q, const robot::Cell& cell) {
    const collision::CellCollision bodies(cell, free.process);
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    return bodies.bodies(frames, {0.0, 0.0, 0.0});
  };
  const robot::Cell cell = robot::Cell::readText(description.dump(), "kr10-r1100-track.json",
                                                 free.process, Printed::plate());
  for (const double at : {-600.0, 0.0, 300.0, 370.0}) {
    JointVector q = cell.home();
    q[kSlide] = at;
    EXPECT_FALSE(post(q, cell)) << at;
  }
  for (const double at : {385.0, 500.0, 640.0, 700.0}) {
    JointVector q = cell.home();
    q[kSlide] = at;
    const auto contact = post(q, cell);
    ASSERT_TRUE(contact) << at;
    const auto name = [&](int b) { return cell.bodies()[static_cast<std::size_t>(b)].name; };
    EXPECT_TRUE(name(contact->first) == "post" || name(contact->second) == "post") << at;
    q[kSlide] = at;
    EXPECT_FALSE(post(q, free.cell)) << at;
  }
  // Planned, the arm keeps off it; the waypoints out of reach on this side are named, with the
  // reason.
  const motion::MotionResult result =
      motion::MotionPlanner(free.plan, cell, process::Tooling(free.process), free.part, {})
          .plan({});
  for (std::size_t i = 0; i < result.trajectory.pointCount(); ++i)
    EXPECT_LT(result.trajectory.at(i)[kSlide], 380.0);
  EXPECT_EQ(result.statistics.collisions, result.skipped.size());
  for (const std::size_t w : result.skipped)
    EXPECT_GT(free.plan.position[w].y(), 380.0);
  EXPECT_FALSE(result.findings.empty());
  for (const plan::Finding& f : result.findings)
    EXPECT_NE(base::english(plan::factOf(f)).find("would collide with post"), std::string::npos)
        << base::english(plan::factOf(f));
}

TEST(Slide, StaysWhereTheArmReachesByItself) {
  for (const char* id : {"kr10-r1100-slide", "kr10-r1100-track"}) {
    const Printed p(lines(50.0), id);
    EXPECT_TRUE(p.result.skipped.empty());
    for (std::size_t i = 0; i < p.result.trajectory.pointCount(); ++i)
      EXPECT_EQ(p.q(i)[kSlide], 0.0) << id;
  }
}
