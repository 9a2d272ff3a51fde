// Plane layers as polygons: the way from a patch and back, levels, and walls by offsets.
#include "base/run_context.h"
#include "painter.h"
#include "patch_shapes.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_volume.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/coverage/plane_walls.h"
#include "toolpath/plane/plane_levels.h"
#include "toolpath/plane/plane_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

using Loops = std::vector<test::Loop>;

constexpr double kHeight = 0.8;

layers::Patch plane(const std::vector<test::Loop>& loops,
                    const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity(),
                    double z = 0.4) {
  layers::Patch patch = test::patchOver(
      loops, 0.8,
      [&](const Vector2d& p) -> Vector3d { return rotation * Vector3d(p.x(), p.y(), z); },
      [](const Vector3d&) { return kHeight; });
  patch.direction.assign(patch.surface.vertices.size(), rotation * Vector3d::UnitZ());
  patch.clearDirection = patch.direction;
  return patch;
}

double areaOf(const layers::Patch& patch) {
  double area = 0.0;
  for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t)
    area += 0.5 * (patch.surface.corner(t, 1) - patch.surface.corner(t, 0))
                      .cross(patch.surface.corner(t, 2) - patch.surface.corner(t, 0))
                      .norm();
  return area;
}

const Eigen::Quaterniond kTurns[] = {
    Eigen::Quaterniond::Identity(), Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d::UnitX())),
    Eigen::Quaterniond(Eigen::AngleAxisd(3.0, Vector3d(1, 2, 0).normalized()))};

TEST(PlanePatch, HasTheAreaOfItsPatchAndGivesItBack) {
  for (const Eigen::Quaterniond& rotation : kTurns)
    for (const Loops& loops :
         {Loops{test::star(7, 12, 6)}, Loops{test::circle(10), test::circle(4, true)}}) {
      const layers::Patch patch = plane(loops, rotation);
      const auto polygon = planePatch(patch);
      ASSERT_TRUE(polygon);
      EXPECT_TRUE(polygon->isEven);
      EXPECT_TRUE(polygon->seams.empty());
      EXPECT_NEAR(geometry::areaMm2(polygon->outline), areaOf(patch), 0.01);
      const auto back = patchOver(polygon->outline, *polygon, patch);
      ASSERT_TRUE(back);
      EXPECT_NEAR(areaOf(*back), areaOf(patch), 0.01);
      EXPECT_TRUE(back->innerRim.empty());
      for (std::size_t t = 0; t < back->surface.triangles.size(); ++t) {
        const Vector3d normal = (back->surface.corner(t, 1) - back->surface.corner(t, 0))
                                    .cross(back->surface.corner(t, 2) - back->surface.corner(t, 0));
        EXPECT_GE(normal.dot(rotation * Vector3d::UnitZ()), 0.0);
      }
      for (const Vector3d& p : back->surface.vertices)
        EXPECT_NEAR(p.dot(rotation * Vector3d::UnitZ()), 0.4, 1e-9);
    }
}

TEST(PlanePatch, ACutIsASeam) {
  const layers::Patch patch = plane({test::rectangle(20, 20)});
  const auto polygon = planePatch(patch);
  ASSERT_TRUE(polygon);
  const auto inside = geometry::offsetPaths(polygon->outline, -4.0, {});
  const auto ring = patchOver(
      geometry::combined(polygon->outline, inside, ClipperLib::ctDifference), *polygon, patch);
  ASSERT_TRUE(ring);
  EXPECT_NEAR(areaOf(*ring), areaOf(patch) - geometry::areaMm2(inside), 0.01);
  const auto again = planePatch(*ring);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->outline.size(), 1U);
  EXPECT_EQ(again->seams.size(), 1U);
}

TEST(PlanePatch, CurvedAndUnevenPatchesAreNone) {
  EXPECT_FALSE(planePatch(test::patchOver({test::circle(10)}, 0.8, test::onSphere(30))));
  layers::Patch thick = plane({test::circle(10)});
  thick.thicknessMm.front() = 1.1;
  ASSERT_TRUE(planePatch(thick));
  EXPECT_FALSE(planePatch(thick)->isEven);
  EXPECT_DOUBLE_EQ(planePatch(thick)->thicknessMm, kHeight);
  EXPECT_FALSE(planePatch(layers::Patch{}));
}

layers::LayerStack squares(const std::vector<double>& heights) {
  layers::LayerStack stack;
  for (const double z : heights) {
    stack.patches.push_back(plane({test::rectangle(10, 10)}, kTurns[0], z));
    stack.patches.back().layer = stack.layerCount++;
  }
  return stack;
}

TEST(PlaneLevels, FollowEachOtherUpToAGap) {
  const layers::LayerStack stack = squares({0.4, 1.2, 2.0, 2.8, 4.8, 5.6});
  const PlaneLevels levels(stack, {});
  EXPECT_EQ(levels.from(0, 1, 9).size(), 3U);
  EXPECT_EQ(levels.from(0, 1, 2).size(), 2U);
  EXPECT_EQ(levels.from(3, -1, 9).size(), 3U);
  EXPECT_EQ(levels.from(4, 1, 9).size(), 1U);
  EXPECT_TRUE(levels.from(4, -1, 9).empty());
  EXPECT_DOUBLE_EQ(levels.from(3, -1, 9).front()->middleMm, 2.0);
}

TEST(PlaneLevels, PatchesOfOneHeightAreOneLevelUnlessOfAnotherItem) {
  layers::LayerStack stack = squares({0.4, 1.2, 1.2});
  EXPECT_EQ(PlaneLevels(stack, {}).from(0, 1, 9).front()->patches.size(), 2U);
  stack.patches[2].item = 1;
  EXPECT_EQ(PlaneLevels(stack, {}).from(0, 1, 9).front()->patches.size(), 1U);
  stack.patches[1].group = layers::kSupportGroup;
  EXPECT_TRUE(PlaneLevels(stack, {}).from(0, 1, 9).empty());
}

// One curved layer, and the skins of an item are found on surfaces.
TEST(PlaneLevels, AnItemWithACurvedLayerHasNone) {
  layers::LayerStack stack = squares({0.4, 1.2});
  stack.patches.push_back(test::patchOver({test::circle(4)}, 0.8, test::onSphere(30)));
  stack.patches.push_back(plane({test::circle(4)}));
  stack.patches.back().item = 1;
  const PlaneLevels levels(stack, {});
  EXPECT_EQ(levels.patch(0), nullptr);
  EXPECT_FALSE(levels.isEven(1));
  EXPECT_NE(levels.patch(3), nullptr);
}

TEST(PlaneWalls, FillTheirBandsExactly) {
  const process::Process process;
  const double hatch = process::hatchOf(process.beadWidthMm, kHeight);
  const ToolpathOptions options;
  for (const Loops& loops :
       {Loops{test::rectangle(30, 24)}, Loops{test::circle(14), test::circle(5, true)},
        Loops{test::ell(40, 16)}}) {
    const layers::Patch patch = plane(loops);
    const auto walls = planeWalls(patch, process, options, {});
    ASSERT_TRUE(walls);
    ASSERT_TRUE(walls->rest);
    EXPECT_EQ(walls->beads.size(), 2U * loops.size());
    EXPECT_NEAR(walls->bandMm2 + areaOf(*walls->rest), areaOf(patch), 0.1);
    EXPECT_NEAR(volumeOf(walls->beads) / (kHeight * walls->bandMm2), 1.0, 0.002);
    for (const Bead& bead : walls->beads) {
      EXPECT_TRUE(bead.closed);
      EXPECT_EQ(bead.kind, plan::PathKind::Wall);
      for (const BeadPoint& p : bead.points)
        EXPECT_NEAR(p.widthMm, process.beadWidthMm, 0.03);
    }
  }
  // A rectangle's walls are rectangles but for their corners.
  const auto walls = planeWalls(plane({test::rectangle(30, 24)}), process, options, {});
  const auto halfWidth = [](const Bead& bead) {
    double x = 0.0;
    for (const BeadPoint& p : bead.points)
      x = std::max(x, p.middle.x());
    return x;
  };
  EXPECT_NEAR(halfWidth(walls->beads[0]), 15.0 - 0.5 * hatch, 1e-3);
  EXPECT_NEAR(halfWidth(walls->beads[1]), 15.0 - 1.5 * hatch, 1e-3);
}

// Where walls would overlap, or leave a gap for less than three beads, beads of other widths tile
// the patch.
TEST(PlaneWalls, LeaveNarrowPlacesToOthers) {
  const process::Process process;
  const double hatch = process::hatchOf(process.beadWidthMm, kHeight);
  const auto strip = [&](double hatches) { return plane({test::rectangle(40, hatches * hatch)}); };
  const auto made = [&](double hatches) {
    return planeWalls(strip(hatches), process, ToolpathOptions{}, {});
  };
  for (const double hatches : {0.6, 1.0, 1.5, 1.85, 2.2, 2.6, 3.0, 3.5, 3.85, 4.2, 5.0}) {
    EXPECT_FALSE(made(hatches)) << hatches;
  }
  for (const double hatches : {2.0, 4.0}) {
    const auto walls = made(hatches);
    ASSERT_TRUE(walls) << hatches;
    EXPECT_FALSE(walls->rest) << hatches;
  }
  for (const double hatches : {6.5, 9.0}) {
    const auto walls = made(hatches);
    ASSERT_TRUE(walls) << hatches;
    ASSERT_TRUE(walls->rest) << hatches;
    EXPECT_NEAR((walls->bandMm2 + areaOf(*walls->rest)) / areaOf(strip(hatches)), 1.0, 1e-4);
  }
}

// Where only walls meet, what they leave open in a tip has beads of its own.
TEST(PlaneWalls, TipsAreFilledWithAnyNumberOfWalls) {
  const layers::Patch star = plane({test::star(7, 15, 7)});
  for (int walls = 1; walls <= 4; ++walls) {
    SCOPED_TRACE(walls);
    ToolpathOptions options;
    options.walls = walls;
    const PatchCover cover = coverPatch(star, process::Process(), options, {});
    const test::Painted painted = test::paint(star, cover.beads);
    EXPECT_GE(painted.coveredMm2 / painted.areaMm2, 0.93); // the tips are sharp
    EXPECT_NEAR(cover.beadVolumeMm3 / cover.volumeMm3, 1.0, 0.01);
  }
}

TEST(PlaneWalls, WallsOfOtherWidthsAreNotTheirs) {
  const process::Process process;
  const layers::Patch patch = plane({test::rectangle(30, 24)});
  std::vector<double> widths(patch.surface.vertices.size(), process.beadWidthMm);
  EXPECT_TRUE(planeWalls(patch, process, ToolpathOptions{}, widths));
  widths.front() += 0.2;
  EXPECT_FALSE(planeWalls(patch, process, ToolpathOptions{}, widths));
  ToolpathOptions none;
  none.walls = 0;
  EXPECT_FALSE(planeWalls(patch, process, none, {}));
}

} // namespace
} // namespace voluta::toolpath
