// Whole plans with a brim, a prime, and settings by feature, on seeded random parts.
#include "patch_shapes.h"
#include "process/bead_model.h"
#include "robot/cell.h"
#include "toolpath/plan_toolpaths.h"

#include "base/run_context.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using plan::PathKind;
using process::Feature;

process::Process usualProcess() {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return process::loadProcess("fdm-1.0");
}

// Two layers of a random star, with or without a hole.
layers::LayerStack randomPart(std::mt19937& random) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const double inner = between(4.0, 7.0);
  std::vector<test::Loop> loops{
      test::star(3 + static_cast<int>(between(0, 4)), inner + between(0.0, 4.0), inner)};
  if (between(0, 1) < 0.5)
    loops.push_back(test::circle(0.3 * inner, true));
  layers::LayerStack stack;
  for (int layer = 0; layer < 2; ++layer) {
    stack.patches.push_back(test::patchOver(
        loops, 0.8, [&](const Vector2d& p) { return Vector3d(p.x(), p.y(), 0.4 + 0.8 * layer); }));
    stack.patches.back().layer = layer;
  }
  stack.layerCount = 2;
  return stack;
}

plan::ToolPlan planned(const layers::LayerStack& stack, const process::Process& process,
                       ToolpathOptions options) {
  const std::vector<Vector2d> plate{{-60, -60}, {60, -60}, {60, 60}, {-60, 60}};
  options.platform = plate;
  return planToolpaths(stack, robot::loadCell("ur5-moving", process, plate),
                       process::Tooling(process), options, base::RunContext())
      .plan;
}

// The waypoints of a plan that are no waste.
std::vector<Vector3d> ofPart(const plan::ToolPlan& plan) {
  std::vector<Vector3d> positions;
  for (const plan::ToolPath& path : plan.paths)
    if (!plan::isWaste(path.kind))
      positions.insert(
          positions.end(), plan.position.begin() + static_cast<std::ptrdiff_t>(path.first),
          plan.position.begin() + static_cast<std::ptrdiff_t>(path.first + path.count));
  return positions;
}

TEST(FirstLayerPlans, aBrimComesBeforeAnUnchangedPart) {
  const process::Process process = usualProcess();
  std::mt19937 random(11);
  for (int round = 0; round < 4; ++round) {
    SCOPED_TRACE(round);
    const layers::LayerStack stack = randomPart(random);
    ToolpathOptions options;
    const std::vector<Vector3d> bare = ofPart(planned(stack, process, options));
    options.brimWidthMm = 3.0;
    options.prime = "line";
    const plan::ToolPlan plan = planned(stack, process, options);
    EXPECT_EQ(ofPart(plan), bare);
    ASSERT_GE(plan.paths.size(), 5u);
    EXPECT_EQ(plan.paths[0].kind, PathKind::Prime);
    std::size_t next = 0;
    bool part = false;
    for (std::size_t k = 0; k < plan.paths.size(); ++k) {
      const plan::ToolPath& path = plan.paths[k];
      EXPECT_EQ(path.first, next);
      next += path.count;
      part = part || !plan::isWaste(path.kind);
      EXPECT_EQ(plan::isWaste(path.kind), !part);
      if (path.kind != PathKind::Skirt)
        continue;
      for (std::size_t i = path.first; i < path.first + path.count; ++i) {
        double minimum = 1e9;
        for (const Vector3d& p : bare)
          if (p.z() < 1.0)
            minimum = std::min(minimum, (p - plan.position[i]).norm());
        ASSERT_GT(minimum, 0.75 * process.beadWidthMm); // Centrelines of neighbours
      }
    }
    EXPECT_EQ(next, plan.waypointCount());
  }
}

TEST(FirstLayerPlans, speedsAreThoseOfTheFeatures) {
  process::Process process = usualProcess();
  process.features.of(Feature::OuterWall).speedMmPerS = 12.0;
  process.features.of(Feature::InnerWall).speedMmPerS = 15.0;
  process.features.of(Feature::Infill).speedMmPerS = 25.0;
  process.features.of(Feature::FirstLayer) = {.speedMmPerS = 8.0, .flow = 1.0, .widthMm = 1.4};
  std::mt19937 random(5);
  for (int round = 0; round < 4; ++round) {
    SCOPED_TRACE(round);
    const layers::LayerStack stack = randomPart(random);
    ToolpathOptions options;
    options.brimWidthMm = 2.0;
    const plan::ToolPlan plan = planned(stack, process, options);
    double volume = 0.0;
    for (const plan::ToolPath& path : plan.paths) {
      const double wanted = path.layer == 0               ? 8.0
                            : path.kind != PathKind::Wall ? 25.0
                            : path.ring == 0              ? 12.0
                                                          : 15.0;
      for (std::size_t i = path.first; i < path.first + path.count; ++i) {
        EXPECT_EQ(plan.speedMmPerS[i], static_cast<float>(wanted));
        if (i > path.first && !plan::isWaste(path.kind))
          volume +=
              process::beadVolume(process::beadArea(plan.widthMm[i - 1], plan.heightMm[i - 1]),
                                  process::beadArea(plan.widthMm[i], plan.heightMm[i]),
                                  (plan.position[i] - plan.position[i - 1]).norm());
      }
    }
    // Wider beads of the first layer tile the same area.
    const plan::ToolPlan usual = planned(stack, usualProcess(), {});
    double usualVolume = 0.0;
    for (const plan::ToolPath& path : usual.paths)
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
        usualVolume +=
            process::beadVolume(process::beadArea(usual.widthMm[i - 1], usual.heightMm[i - 1]),
                                process::beadArea(usual.widthMm[i], usual.heightMm[i]),
                                (usual.position[i] - usual.position[i - 1]).norm());
    EXPECT_NEAR(volume / usualVolume, 1.0, 0.02);
  }
}

} // namespace
} // namespace voluta::toolpath
