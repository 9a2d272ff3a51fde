// Shots behind the layers that end at their pockets.
#include "toolpath/stitching/add_shots.h"

#include "base/units.h"

#include <gtest/gtest.h>

namespace voluta::toolpath {
namespace {

using Eigen::Vector3d;

// Two straight beads on each of four layers.
plan::ToolPlan beads() {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 4; ++layer)
    for (const double y : {0.0, 1.0}) {
      plan.paths.push_back({.first = plan.waypointCount(), .count = 2, .layer = layer});
      for (const double x : {-10.0, 10.0}) {
        plan.position.emplace_back(x, y, layer + 1.0);
        plan.direction.emplace_back(0, 0, 1);
        plan.widthMm.push_back(1.2f);
        plan.heightMm.push_back(1.0f);
        plan.speedMmPerS.push_back(20.0f);
      }
    }
  return plan;
}

layers::Pocket pocketAt(const Vector3d& top, int layer) {
  return {.top = top, .volumeMm3 = 184.3, .depthMm = 6.0, .openingMm = 4.0, .layer = layer};
}

process::Tooling tooling() {
  process::Process process;
  process.travelSpeedMmPerS = 100.0;
  return process::Tooling(process);
}

// The heights and speeds of table 6.1: at 2 mm above the pocket, 0.6 mm into it at 10 mm/s, and up
// at 50 mm/s; E 26 mm + 15 % = 30 mm of filament of 3 mm.
TEST(AddedShots, AreCastellis) {
  plan::ToolPlan plan = beads();
  const std::vector<layers::Pocket> pockets{pocketAt({3, 0, 2}, 1)};
  addShots(plan, pockets, tooling(), {.excess = 0.15, .depthMm = 0.6});
  ASSERT_EQ(plan.paths.size(), 9u);
  const plan::ToolPath& shot = plan.paths[4]; // behind the beads of two layers
  ASSERT_EQ(shot.kind, plan::PathKind::Shot);
  EXPECT_EQ(shot.layer, 1);
  EXPECT_TRUE(plan.position[shot.first].isApprox(Vector3d(3, 0, 4)));
  EXPECT_TRUE(plan.position[shot.first + 1].isApprox(Vector3d(3, 0, 1.4)));
  EXPECT_TRUE(plan.position[shot.first + 2].isApprox(Vector3d(3, 0, 4)));
  EXPECT_FLOAT_EQ(plan.speedMmPerS[shot.first + 1], 10.0f);
  EXPECT_FLOAT_EQ(plan.speedMmPerS[shot.first + 2], 50.0f);
  EXPECT_EQ(plan.shotAt(shot), shot.first + 1);
  EXPECT_NEAR(plan.shotMm3(shot), 1.15 * 184.3, 1e-3);
  EXPECT_NEAR(plan.shotMm3(shot) / (base::kPi / 4.0 * 9.0), 30.0, 0.05);
}

TEST(AddedShots, KeepAllBeadsAndTheirOrder) {
  const plan::ToolPlan before = beads();
  plan::ToolPlan plan = before;
  plan.fill = {{.shellMm = 3.0, .openMm3 = 7.0}};
  const std::vector<layers::Pocket> pockets{pocketAt({3, 0, 2}, 1), pocketAt({9, 0, 2}, 1),
                                            pocketAt({-9, 0, 4}, 3)};
  addShots(plan, pockets, tooling(), {});
  ASSERT_EQ(plan.paths.size(), before.paths.size() + 3);
  EXPECT_DOUBLE_EQ(plan.fill.at(0).openMm3, 7.0);
  // The nearest one to the last bead's end first.
  EXPECT_DOUBLE_EQ(plan.position[plan.paths[4].first].x(), 9.0);
  EXPECT_DOUBLE_EQ(plan.position[plan.paths[5].first].x(), 3.0);
  std::size_t next = 0;
  for (const plan::ToolPath& path : plan.paths) {
    if (path.kind == plan::PathKind::Shot)
      continue;
    const plan::ToolPath& was = before.paths[next++];
    EXPECT_EQ(path.layer, was.layer);
    for (std::size_t i = 0; i < was.count; ++i)
      EXPECT_EQ(plan.position[path.first + i], before.position[was.first + i]);
  }
}

TEST(AddedShots, BeadsOnAPocketAreSupported) {
  const plan::ToolPlan plan = beads();
  std::vector<char> unsupported(plan.waypointCount(), 1);
  const std::vector<layers::Pocket> pockets{pocketAt({10, 0, 2}, 1)};
  acceptBeadsOnPockets(plan, pockets, unsupported);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    const bool isOn = plan.position[i].x() > 0.0 && plan.position[i].z() == 3.0;
    EXPECT_EQ(unsupported[i], isOn ? 0 : 1) << i;
  }
}

} // namespace
} // namespace voluta::toolpath
