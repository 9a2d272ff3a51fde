// Walls that overhang the layer below are slowed by the share of their width.
#include "toolpath/slow_overhangs.h"

#include "base/run_context.h"
#include "patch_shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kWidth = 0.4, kHeight = 0.2;

layers::Patch square(double x, double z) {
  return test::patchOver(
      {test::rectangle(20, 20)}, 2.0,
      [&](const Vector2d& p) { return Vector3d(p.x() + x, p.y(), z); },
      [](const Vector3d&) { return kHeight; });
}

// A wall along the side of the upper square that overhangs by `byMm`.
struct Scene {
  layers::LayerStack stack;
  plan::ToolPlan plan;
  process::Process process;

  explicit Scene(double byMm) {
    stack.patches = {square(0.0, 0.1), square(byMm, 0.3)};
    stack.patches[1].layer = 1;
    stack.layerCount = 2;
    process.beadWidthMm = kWidth;
    process.layerHeightMm = kHeight;
    process.speedMmPerS = 40.0;
    process.overhangSpeed.shares = {0.8, 0.6, 0.5, 0.25};
    addWall(0, -5.0, 10.0 - 0.5 * kWidth, 0.2);
    addWall(1, -5.0, 10.0 + byMm - 0.5 * kWidth, 0.4);
  }

  void addWall(int patch, double y, double x, double z) {
    plan::ToolPath path;
    path.first = plan.waypointCount();
    path.count = 11;
    path.kind = plan::PathKind::Wall;
    path.patch = path.layer = patch;
    for (int i = 0; i < 11; ++i) {
      plan.position.emplace_back(x, y + i, z);
      plan.direction.push_back(Vector3d::UnitZ());
      plan.widthMm.push_back(kWidth);
      plan.heightMm.push_back(kHeight);
      plan.speedMmPerS.push_back(40.0F);
    }
    plan.paths.push_back(path);
  }

  double speed(std::size_t path) const { return plan.speedMmPerS[plan.paths[path].first + 5]; }

  void run() { slowOverhangs(plan, stack, process::Tooling(process), base::RunContext()); }
};

TEST(SlowOverhangs, ByTheShareOfTheirWidth) {
  const struct {
    double share, speed;
  } rows[] = {{0.0, 40.0},  {0.05, 40.0}, {0.24, 32.0}, {0.49, 24.0},
              {0.74, 20.0}, {0.99, 10.0}, {2.0, 10.0}};
  for (const auto& [share, speed] : rows) {
    Scene scene(share * kWidth);
    scene.run();
    EXPECT_NEAR(scene.speed(1), speed, 1e-4) << share;
    EXPECT_EQ(scene.speed(0), 40.0) << "on the plate";
  }
}

TEST(SlowOverhangs, NeverFaster) {
  Scene scene(0.49 * kWidth);
  for (float& speed : scene.plan.speedMmPerS)
    speed = 5.0F;
  scene.run();
  EXPECT_EQ(scene.speed(1), 5.0);
}

TEST(SlowOverhangs, ConcernWallsAndProcessesThatSaySo) {
  Scene infill(0.49 * kWidth), neutral(0.49 * kWidth);
  for (plan::ToolPath& path : infill.plan.paths)
    path.kind = plan::PathKind::Infill;
  neutral.process.overhangSpeed = {};
  for (Scene* scene : {&infill, &neutral}) {
    scene->run();
    EXPECT_EQ(scene->speed(1), 40.0);
  }
}

TEST(OverhangSpeed, IsLinearBetweenItsShares) {
  process::OverhangSpeed speed;
  EXPECT_EQ(speed.at(0.7), 1.0);
  speed.shares = {0.8, 0.6, 0.5, 0.25};
  EXPECT_DOUBLE_EQ(speed.at(0.0), 1.0);
  EXPECT_DOUBLE_EQ(speed.at(0.125), 0.9);
  EXPECT_DOUBLE_EQ(speed.at(0.25), 0.8);
  EXPECT_DOUBLE_EQ(speed.at(0.625), 0.55);
  EXPECT_DOUBLE_EQ(speed.at(1.0), 0.25);
  EXPECT_DOUBLE_EQ(speed.at(3.0), 0.25);
}

} // namespace
} // namespace voluta::toolpath
