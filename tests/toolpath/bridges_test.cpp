// Unsupported beads, and their speeds.
#include "collision/growing_part.h"
#include "toolpath/unsupported/bridges.h"

#include "one_pass.h"
#include "toolpath/unsupported/slow_bridges.h"

#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::test;
using Eigen::Vector3d;

namespace {

std::vector<char> unsupportedOf(const plan::ToolPlan& plan,
                                const platform::PlatformSolid& platform) {
  const double pitch = collision::growingPitch(plan, process::Tooling(kProcess));
  const base::RunContext ctx;
  const collision::GrowingPart part(plan, pitch, ctx,
                                    collision::groundCells(platform, plan, pitch, ctx));
  return toolpath::unsupportedWaypoints(plan, part, platform, ctx);
}

plan::ToolPlan slowed(const plan::ToolPlan& plan, const std::vector<char>& unsupported,
                      const process::Tooling& tooling) {
  return toolpath::slowBridges({plan, unsupported, {}, {}}, {}, sceneOn(kPlate, tooling), {})
      .value()
      .beads.plan;
}

} // namespace

TEST(Bridges, SpanTheGapBetweenTwoWalls) {
  plan::ToolPlan plan;
  addPath(plan, -15, -5, 0, 0.8, 0);
  addPath(plan, 5, 15, 0, 0.8, 0);
  addPath(plan, -15, 15, 0, 1.6, 1); // over the gap from x = -5 to 5, whose ends are round
  const std::vector<char> unsupported = unsupportedOf(plan, kPlate);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    const Vector3d& p = plan.position[i];
    if (p.z() > 1.0 && std::abs(p.x()) > 4.1 && std::abs(p.x()) < 5.9)
      continue; // above a round end
    EXPECT_EQ(unsupported[i] != 0, p.z() > 1.0 && std::abs(p.x()) <= 4.1) << p.transpose();
  }
}

TEST(Bridges, ABeadHalfBesideTheOneBelowIsCarried) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8, 0);
  addPath(plan, -15, 15, 0.6, 1.6, 1);
  addPath(plan, 15, -15, 3.0, 1.6, 1); // nothing below
  const std::vector<char> unsupported = unsupportedOf(plan, kPlate);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i)
    EXPECT_EQ(unsupported[i] != 0, plan.position[i].y() > 2.0) << plan.position[i].transpose();
}

TEST(Bridges, LaterBeadsCarryNothing) {
  plan::ToolPlan plan;
  addPath(plan, -10, 10, 0, 1.6, 1);
  addPath(plan, -10, 10, 0, 0.8, 0);
  const std::vector<char> unsupported = unsupportedOf(plan, kPlate);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i)
    EXPECT_EQ(unsupported[i] != 0, i < plan.paths[1].first);
}

TEST(Bridges, BeyondThePlateNothingCarries) {
  plan::ToolPlan plan;
  addPath(plan, 0, 40, 0, 0.8, 0);
  const std::vector<char> unsupported = unsupportedOf(plan, kPlate);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i)
    EXPECT_EQ(unsupported[i] != 0, plan.position[i].x() > 20.0) << plan.position[i].transpose();
}

TEST(Bridges, HolesOfLessThanAWidthAreNone) {
  plan::ToolPlan plan;
  addPath(plan, -15, -1, 0, 0.8, 0);
  addPath(plan, 1, 15, 0, 0.8, 0); // round ends: less than a millimetre is left between them
  addPath(plan, -15, 15, 0, 1.6, 1);
  const std::vector<char> unsupported = unsupportedOf(plan, kPlate);
  EXPECT_EQ(std::count(unsupported.begin(), unsupported.end(), 1), 0);
}

TEST(Bridges, ArePrintedSlowly) {
  plan::ToolPlan plan;
  addPath(plan, 0, 10, 0, 0.8, 0);
  plan.speedMmPerS[6] = 3.0f; // for its own reason
  std::vector<char> unsupported(plan.waypointCount(), 0);
  unsupported[4] = unsupported[5] = unsupported[6] = 1;
  plan = slowed(plan, unsupported, process::Tooling(kProcess));
  const auto slow = static_cast<float>(kProcess.bridgeSpeedMmPerS);
  EXPECT_LT(slow, 20.0f);
  const std::vector<float> expected{20, 20, 20, 20, slow, slow, 3, slow, 20, 20, 20};
  EXPECT_EQ(plan.speedMmPerS, expected);
}

TEST(Bridges, AreAsSlowAsTheirToolNeeds) {
  process::Tool first, second;
  first.process = second.process = kProcess;
  second.process.bridgeSpeedMmPerS = 2.0;
  plan::ToolPlan plan;
  addPath(plan, 0, 5, 0, 0.8, 0);
  addPath(plan, 0, 5, 5, 0.8, 0);
  plan.paths.back().tool = 1;
  plan =
      slowed(plan, std::vector<char>(plan.waypointCount(), 1), process::Tooling({first, second}));
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      EXPECT_EQ(plan.speedMmPerS[i],
                path.tool == 1 ? 2.0f : static_cast<float>(kProcess.bridgeSpeedMmPerS));
}
