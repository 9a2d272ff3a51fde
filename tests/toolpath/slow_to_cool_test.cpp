// Beads printed slower so that those below them can cool: closed forms for a ring and a spiral.
#include "toolpath/slow_to_cool.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::toolpath {
namespace {

constexpr double kRadiusMm = 20.0, kHeightMm = 0.8;
constexpr int kPoints = 120;

void add(plan::ToolPlan& plan, const std::vector<Eigen::Vector3d>& points, double speed) {
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.count = points.size();
  for (const Eigen::Vector3d& p : points) {
    plan.position.push_back(p);
    plan.direction.push_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(1.2F);
    plan.heightMm.push_back(static_cast<float>(kHeightMm));
    plan.speedMmPerS.push_back(static_cast<float>(speed));
  }
  plan.paths.push_back(path);
}

// Points of a helix that rises by a height for each turn; level: rings, one a turn.
std::vector<Eigen::Vector3d> turns(int count, double z, double rise) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k <= count * kPoints; ++k) {
    const double revolution = static_cast<double>(k) / kPoints;
    points.emplace_back(kRadiusMm * std::cos(2.0 * base::kPi * revolution),
                        kRadiusMm * std::sin(2.0 * base::kPi * revolution), z + rise * revolution);
  }
  return points;
}
// The speed at which a turn takes 40 s.
double usualSpeed() {
  return 2.0 * kRadiusMm * kPoints * std::sin(base::kPi / kPoints) / 40.0;
}
double secondsOf(const plan::ToolPlan& plan, std::size_t first, std::size_t count) {
  double seconds = 0.0;
  for (std::size_t w = first + 1; w <= first + count; ++w)
    seconds +=
        (plan.position[w] - plan.position[w - 1]).norm() / static_cast<double>(plan.speedMmPerS[w]);
  return seconds;
}

plan::ToolPlan rings(int layers) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < layers; ++layer)
    add(plan, turns(1, (layer + 1) * kHeightMm, 0.0), usualSpeed());
  return plan;
}

TEST(SlowToCool, ARingTakesTheMinimumTime) {
  plan::ToolPlan plan = rings(12);
  slowToCool(plan, {.minLayerTimeS = 60.0, .slowestMmPerS = 0.1});
  for (const plan::ToolPath& path : plan.paths)
    EXPECT_NEAR(secondsOf(plan, path.first, path.count - 1), 60.0, 0.6) << path.first;
}

TEST(SlowToCool, ASpiralTakesTheMinimumTimePerRevolution) {
  plan::ToolPlan plan;
  add(plan, turns(8, kHeightMm, kHeightMm), usualSpeed());
  slowToCool(plan, {.minLayerTimeS = 60.0, .slowestMmPerS = 0.1});
  for (int revolution = 0; revolution < 7; ++revolution)
    EXPECT_NEAR(secondsOf(plan, static_cast<std::size_t>(revolution * kPoints), kPoints), 60.0, 1.0)
        << revolution;
}

TEST(SlowToCool, NoSlowerThanAllowed) {
  plan::ToolPlan plan = rings(4);
  const auto slowest = static_cast<float>(0.9 * usualSpeed());
  slowToCool(plan, {.minLayerTimeS = 60.0, .slowestMmPerS = static_cast<double>(slowest)});
  EXPECT_FLOAT_EQ(*std::ranges::min_element(plan.speedMmPerS), slowest);
}

TEST(SlowToCool, EnoughTimeChangesNothing) {
  const plan::ToolPlan before = rings(4);
  for (const CoolingOptions& options : {CoolingOptions{39.0, 0.1}, CoolingOptions{60.0, 0.0},
                                        CoolingOptions{0.0, 0.1}, CoolingOptions{60.0, 500.0}}) {
    plan::ToolPlan plan = before;
    slowToCool(plan, options);
    EXPECT_EQ(plan.speedMmPerS, before.speedMmPerS);
  }
}

} // namespace
} // namespace voluta::toolpath
