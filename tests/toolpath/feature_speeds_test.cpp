// Speeds, flows and widths by feature.
#include "patch_shapes.h"
#include "process/bead_model.h"
#include "process/tooling.h"
#include "toolpath/feature_speeds.h"
#include "toolpath/first_layer.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

using plan::PathKind;
using process::Feature;

constexpr std::size_t kPoints = 5; // of each path

void addPath(plan::ToolPlan& plan, PathKind kind, int ring = 0, int patch = 1) {
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.count = kPoints;
  path.kind = kind;
  path.ring = ring;
  path.patch = patch;
  for (std::size_t i = 0; i < kPoints; ++i) {
    plan.position.emplace_back(static_cast<double>(i), 0.0, 0.8);
    plan.direction.emplace_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(0.8f);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back(path);
}

// Patch 0 is on the first layer, patch 1 is not.
const std::vector<char> kFirstLayer{1, 0};

bool apply(plan::ToolPlan& plan, const process::Process& process,
           std::vector<char> unsupported = {}) {
  unsupported.resize(plan.waypointCount(), 0);
  return applyFeatures(plan, process::Tooling(process), kFirstLayer, unsupported);
}

TEST(FeatureSpeeds, withoutSettingsNothingChanges) {
  plan::ToolPlan plan;
  for (const PathKind kind : {PathKind::Skirt, PathKind::Wall, PathKind::Infill, PathKind::Support})
    addPath(plan, kind, 0, 0);
  plan.speedMmPerS[3] = 7.0f;
  const plan::ToolPlan before = plan;
  EXPECT_FALSE(apply(plan, {}));
  EXPECT_EQ(plan.speedMmPerS, before.speedMmPerS);
  EXPECT_EQ(plan.widthMm, before.widthMm);
}

TEST(FeatureSpeeds, eachFeatureHasItsOwn) {
  process::Process process;
  process.maxFlowMm3PerS = 1000.0;
  double speed = 10.0;
  for (const process::FeatureRow& row : process::featureRows())
    if (row.hasSpeed)
      process.features.of(row.feature).speedMmPerS = speed += 1.0;
  const struct {
    PathKind kind;
    int ring, patch;
    Feature feature;
  } rows[] = {
      {PathKind::Wall, 0, 1, Feature::OuterWall},    {PathKind::Wall, 2, 1, Feature::InnerWall},
      {PathKind::Infill, 0, 1, Feature::Infill},     {PathKind::GapFill, 0, 1, Feature::Infill},
      {PathKind::Support, 0, 1, Feature::Support},   {PathKind::Wall, 0, 0, Feature::FirstLayer},
      {PathKind::Infill, 0, 0, Feature::FirstLayer}, {PathKind::Skirt, 0, 0, Feature::FirstLayer}};
  for (const auto& row : rows) {
    plan::ToolPlan plan;
    addPath(plan, row.kind, row.ring, row.patch);
    EXPECT_FALSE(apply(plan, process));
    for (const float v : plan.speedMmPerS)
      EXPECT_EQ(v, static_cast<float>(process.features.of(row.feature).speedMmPerS));
  }
  plan::ToolPlan prime;
  addPath(prime, PathKind::Prime, 0, 0);
  apply(prime, process);
  EXPECT_EQ(prime.speedMmPerS, std::vector<float>(kPoints, 20.0f));
}

TEST(FeatureSpeeds, bridgesStaySlow) {
  process::Process process;
  process.features.of(Feature::Infill).speedMmPerS = 30.0;
  plan::ToolPlan plan;
  addPath(plan, PathKind::Infill);
  apply(plan, process, {0, 1, 0, 0, 0});
  const auto slow = static_cast<float>(process.bridgeSpeedMmPerS);
  EXPECT_EQ(plan.speedMmPerS, (std::vector<float>{30, slow, slow, 30, 30}));
}

// The section that is deposited is the flow times the planned one.
TEST(FeatureSpeeds, aFlowScalesTheSection) {
  for (const double flow : {0.95, 1.0, 1.05, 1.2}) {
    process::Process process;
    process.features.of(Feature::InnerWall).flow = flow;
    plan::ToolPlan plan;
    addPath(plan, PathKind::Wall, 0);
    addPath(plan, PathKind::Wall, 1);
    EXPECT_EQ(apply(plan, process), flow != 1.0);
    const double usual = process::beadArea(1.2f, 0.8f);
    for (std::size_t i = 0; i < plan.waypointCount(); ++i)
      EXPECT_NEAR(process::beadArea(plan.widthMm[i], plan.heightMm[i]) / usual,
                  i < kPoints ? 1.0 : flow, 1e-6);
  }
}

TEST(FeatureSpeeds, flowsOfTheFirstLayerAndOfTheFeatureMultiply) {
  process::Process process;
  process.features.of(Feature::OuterWall).flow = 1.1;
  process.features.of(Feature::FirstLayer).flow = 1.2;
  plan::ToolPlan plan;
  addPath(plan, PathKind::Wall, 0, 0);
  apply(plan, process);
  EXPECT_NEAR(process::beadArea(plan.widthMm[0], 0.8f), 1.32 * process::beadArea(1.2f, 0.8f), 1e-6);
}

TEST(FeatureSpeeds, bridgesHaveTheirFlowAndClosedBeadsCloseEvenly) {
  process::Process process;
  process.features.of(Feature::Bridge).flow = 1.1;
  plan::ToolPlan plan;
  addPath(plan, PathKind::Wall);
  plan.paths[0].closed = true;
  apply(plan, process, {1, 0, 0, 0, 0});
  EXPECT_GT(plan.widthMm[0], 1.2f);
  EXPECT_EQ(plan.widthMm[1], 1.2f);
  EXPECT_EQ(plan.widthMm[4], plan.widthMm[0]);
}

// Property test: the extruder's limit is kept by speed, the section by the flow and the limits of
// the bead, for all settings.
TEST(FeatureSpeeds, theFlowLimitSlowsDown) {
  std::mt19937 random(3);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  for (int round = 0; round < 300; ++round) {
    process::Process process;
    process.maxFlowMm3PerS = between(2.0, 60.0);
    for (const process::FeatureRow& row : process::featureRows()) {
      process.features.of(row.feature).flow = between(0.5, 2.0);
      if (row.hasSpeed && between(0, 1) < 0.7)
        process.features.of(row.feature).speedMmPerS = between(1.0, 100.0);
    }
    plan::ToolPlan plan;
    for (int k = 0; k < 6; ++k)
      addPath(plan, static_cast<PathKind>(k % 5), k % 3, k % 2);
    for (float& width : plan.widthMm)
      width = static_cast<float>(between(process.beadWidthMinMm, process.beadWidthMaxMm));
    const double maximum = process::beadArea(process.beadWidthMaxMm, 0.8f);
    std::ranges::fill(plan.speedMmPerS, static_cast<float>(process.maxFlowMm3PerS / maximum));
    std::vector<char> unsupported;
    for (std::size_t i = 0; i < plan.waypointCount(); ++i)
      unsupported.push_back(between(0, 1) < 0.2 ? 1 : 0);
    const std::vector<float> before = plan.widthMm;
    apply(plan, process, unsupported);
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      ASSERT_GT(plan.speedMmPerS[i], 0.0f);
      ASSERT_GE(plan.widthMm[i], static_cast<float>(process.beadWidthMinMm));
      ASSERT_LE(plan.widthMm[i], static_cast<float>(process.beadWidthMaxMm));
      ASSERT_LE(process::beadArea(plan.widthMm[i], plan.heightMm[i]) * plan.speedMmPerS[i],
                process.maxFlowMm3PerS * (1.0 + 1e-5));
    }
  }
}

TEST(FeatureSpeeds, firstLayersAndSupportsHaveTheirWidth) {
  process::Process process;
  process.features.of(Feature::FirstLayer).widthMm = 1.6;
  process.features.of(Feature::Support).widthMm = 1.4;
  process.features.of(Feature::OuterWall).widthMm = 1.5;
  const process::Tooling tooling(process);
  layers::LayerStack stack;
  for (int layer = 0; layer < 3; ++layer)
    stack.patches.push_back(test::patchOver({test::circle(4.0)}));
  stack.patches[1].layer = 1;
  stack.patches[2].layer = 1;
  stack.patches[2].group = layers::kSupportGroup;
  const std::vector<char> first{1, 0, 0};
  EXPECT_EQ(processOf(stack.patches[0], tooling, true).beadWidthMm, 1.6);
  EXPECT_EQ(processOf(stack.patches[1], tooling, false).beadWidthMm, process.beadWidthMm);
  EXPECT_EQ(processOf(stack.patches[2], tooling, false).beadWidthMm, 1.4);
  std::vector<std::vector<double>> widths;
  for (const layers::Patch& patch : stack.patches)
    widths.emplace_back(patch.surface.vertices.size(), process.beadWidthMm);
  widths[1][0] = 1.9;
  setWallWidths(stack, tooling, first, widths);
  EXPECT_TRUE(widths[0].empty());
  EXPECT_TRUE(widths[2].empty());
  EXPECT_EQ(widths[1][0], 1.9);
  EXPECT_EQ(std::ranges::count(widths[1], 1.5), static_cast<long>(widths[1].size()) - 1);
}

TEST(FirstLayer, isLevelZeroAndPatchesOnThePlate) {
  layers::LayerStack stack;
  const auto at = [](double z) {
    return [z](const Eigen::Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), z); };
  };
  for (const double z : {0.4, 1.2, 0.4}) // middles of layers 0.8 mm high
    stack.patches.push_back(test::patchOver({test::circle(4.0)}, 0.8, at(z)));
  stack.patches[1].layer = 1;
  stack.patches[2].layer = 7; // of another piece
  const platform::PlatformSolid plate{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
  EXPECT_EQ(firstLayerPatches(stack, plate), (std::vector<char>{1, 0, 1}));
  EXPECT_EQ(firstLayerPatches(stack, {}), (std::vector<char>{1, 0, 0}));
}

} // namespace
} // namespace voluta::toolpath
