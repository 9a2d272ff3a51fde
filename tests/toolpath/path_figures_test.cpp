// Closed forms of the figures that follow from the paths of a plan.
#include "toolpath/path_figures.h"

#include "base/units.h"
#include "process/bead_model.h"
#include "toolpath/straight_beads.h"

#include <gtest/gtest.h>

namespace voluta::toolpath {
namespace {

using plan::PathKind;

// Straight paths of 10 mm along x, one millimetre apart; shots stay in one place.
plan::ToolPlan pathsOf(const std::vector<PathKind>& kinds, const std::vector<int>& items = {}) {
  plan::ToolPlan plan;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const bool isShot = kinds[k] == PathKind::Shot;
    test::addPath(plan, 0.0, isShot ? 1.0 : 10.0, static_cast<double>(k), 0.8, 0);
    plan.paths.back().kind = kinds[k];
    plan.paths.back().item = k < items.size() ? items[k] : 0;
  }
  return plan;
}

const process::Tooling kTooling(test::kProcess);
const double kBeadMm3 = 10.0 * process::beadArea(1.2F, 0.8F);

TEST(PathFigures, WasteIsLengthButNoMaterial) {
  const plan::ToolPlan plan =
      pathsOf({PathKind::Skirt, PathKind::Prime, PathKind::Wall, PathKind::Support});
  plan::ToolpathStatistics s;
  setPathFigures(plan, 1, kTooling, s);
  EXPECT_EQ(s.paths, 4u);
  EXPECT_EQ(s.starts, 4u);
  EXPECT_EQ(s.waypoints, 44u);
  EXPECT_NEAR(s.lengthMm, 40.0, 1e-9);
  EXPECT_NEAR(s.travelMm, 3.0 * std::hypot(10.0, 1.0), 1e-9);
  EXPECT_NEAR(s.materialMm3, 2.0 * kBeadMm3, 1e-6);
  EXPECT_TRUE(s.items.empty());
}

TEST(PathFigures, TapesAreNoBeads) {
  plan::ToolPlan plan = pathsOf({PathKind::Wall, PathKind::Tape, PathKind::Tape});
  plan::ToolpathStatistics s;
  setPathFigures(plan, 1, kTooling, s);
  EXPECT_NEAR(s.lengthMm, 10.0, 1e-9);
  EXPECT_NEAR(s.materialMm3, kBeadMm3, 1e-6);
  EXPECT_EQ(s.tapes, 2u);
  EXPECT_NEAR(s.tapeMm, 20.0, 1e-9);
  // A tool without tape: the section of the paths.
  const double density = test::kProcess.material.densityGPerCm3;
  EXPECT_NEAR(s.tapeG, 20.0 * 1.2 * 0.8 * density / 1000.0, 1e-6);

  process::Process tape = test::kProcess;
  tape.tape = process::Tape{};
  tape.material.densityGPerCm3 = 2.0 * density;
  for (plan::ToolPath& path : plan.paths)
    path.tool = path.kind == PathKind::Tape ? 1 : 0;
  setPathFigures(plan, 1, process::Tooling({{test::kProcess}, {tape}}), s);
  EXPECT_NEAR(s.tapeG, 20.0 * 5.0 * 0.08 * 2.0 * density / 1000.0, 1e-9);
}

TEST(PathFigures, ShotsAreMaterialWithoutLength) {
  const plan::ToolPlan plan = pathsOf({PathKind::Wall, PathKind::Shot});
  plan::ToolpathStatistics s;
  setPathFigures(plan, 1, kTooling, s);
  setPathFigures(plan, 1, kTooling, s); // set, not added
  EXPECT_EQ(s.shots, 1u);
  EXPECT_NEAR(s.shotMm3, base::kPi / 4.0 * 1.2 * 1.2 * 0.8, 1e-6);
  EXPECT_NEAR(s.materialMm3, kBeadMm3 + s.shotMm3, 1e-6);
  EXPECT_NEAR(s.lengthMm, 10.0, 1e-9);
}

TEST(PathFigures, ItemsAddUpToTheJob) {
  const plan::ToolPlan plan =
      pathsOf({PathKind::Skirt, PathKind::Wall, PathKind::Infill, PathKind::Wall}, {0, 0, 1, 1});
  plan::ToolpathStatistics s;
  setPathFigures(plan, 3, kTooling, s);
  ASSERT_EQ(s.items.size(), 3u);
  EXPECT_EQ(s.items[0].paths, 1u);
  EXPECT_EQ(s.items[1].paths, 2u);
  EXPECT_EQ(s.items[2].paths, 0u);
  EXPECT_NEAR(s.items[0].lengthMm, 10.0, 1e-9) << "without waste";
  EXPECT_NEAR(s.items[0].materialMm3 + s.items[1].materialMm3, s.materialMm3, 1e-9);
}

TEST(PathFigures, RotationIsWithinPathsOnly) {
  plan::ToolPlan plan = pathsOf({PathKind::Wall, PathKind::Wall});
  for (std::size_t i = 11; i < plan.waypointCount(); ++i)
    plan.direction[i] = Eigen::Vector3d(1.0, 0.0, 1.0).normalized();
  EXPECT_NEAR(maxRotationDeg(plan), 0.0, 1e-6);
  plan.direction[3] = Eigen::Vector3d(0.0, 1.0, 1.0).normalized();
  EXPECT_NEAR(maxRotationDeg(plan), 45.0, 1e-6);
}

} // namespace
} // namespace voluta::toolpath
