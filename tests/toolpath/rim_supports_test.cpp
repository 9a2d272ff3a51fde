// Beads of support under rims that would be unsupported just over the plate.
#include "toolpath/unsupported/rim_supports.h"

#include "collision/growing_part.h"
#include "layers/layer_stack.h"
#include "one_pass.h"
#include "process/bead_model.h"
#include "toolpath/unsupported/bridges.h"
#include "voxel/voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using namespace voluta::test;
using Eigen::Vector3d;

namespace {

struct Underlaid {
  plan::ToolPlan plan;
  std::vector<Vector3d> clearDirection;
  std::size_t underlaid = 0; // paths, as returned
  double volumeMm3 = 0.0;
  std::shared_ptr<const collision::GrowingPart> grown;
};

// The result of the passes before directions.
Underlaid underlaid(const plan::ToolPlan& plan, const platform::PlatformSolid& platform = kPlate) {
  toolpath::PassedPlan passed = afterPhase(toolpath::PassPhase::BeforeDirections, plan, platform);
  std::size_t paths = 0;
  for (const plan::Finding& finding : passed.findings)
    paths += finding.count;
  return {std::move(passed.beads.plan), std::move(passed.beads.clearDirection), paths,
          passed.addedMm3, std::move(passed.grown)};
}

std::vector<char> unsupportedOf(const plan::ToolPlan& plan) {
  const collision::GrowingPart part(plan, collision::growingPitch(plan, process::Tooling(kProcess)),
                                    {});
  return toolpath::unsupportedWaypoints(plan, part, kPlate, {});
}

// A foot of one bead, and over it a layer that exceeds it by 3 beads on one side.
plan::ToolPlan roundFoot() {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8, 0);
  addPath(plan, -15, 15, 2.4, 1.6, 1);
  addPath(plan, -15, 15, 0, 1.6, 1);
  return plan;
}

} // namespace

TEST(Underlay, IsOnThePlateUnderALowRimAndBeforeItsPatch) {
  const plan::ToolPlan plan = roundFoot();
  const Underlaid out = underlaid(plan);
  ASSERT_EQ(out.plan.paths.size(), 4u);
  EXPECT_EQ(out.underlaid, 1u);
  const plan::ToolPath& under = out.plan.paths[1];
  EXPECT_EQ(under.kind, plan::PathKind::Support);
  EXPECT_EQ(under.group, layers::kSupportGroup);
  EXPECT_EQ(under.count, 31u);
  double volume = 0.0;
  for (std::size_t i = under.first; i < under.first + under.count; ++i) {
    const auto height = static_cast<double>(out.plan.heightMm[i]);
    EXPECT_DOUBLE_EQ(out.plan.position[i].y(), 2.4);
    // From the plate to a fourteenth of a bead's height under the rim's bead.
    EXPECT_NEAR(out.plan.position[i].z() - height, 0.0, 1e-6);
    EXPECT_NEAR(out.plan.position[i].z(), 0.8 - 0.8 / 14.0, 1e-6);
    if (i > under.first)
      volume += process::beadArea(kProcess.beadWidthMinMm, height);
  }
  EXPECT_NEAR(out.volumeMm3, volume, 1e-3);
  EXPECT_EQ(out.clearDirection.size(), out.plan.waypointCount());
  // Former paths are unchanged, in their order.
  std::vector<Vector3d> part;
  for (const plan::ToolPath& path : out.plan.paths)
    if (path.kind != plan::PathKind::Support)
      part.insert(part.end(), out.plan.position.begin() + static_cast<std::ptrdiff_t>(path.first),
                  out.plan.position.begin() + static_cast<std::ptrdiff_t>(path.first + path.count));
  EXPECT_EQ(part, plan.position);
  EXPECT_TRUE(std::ranges::count(unsupportedOf(plan), 1) > 20);
  EXPECT_EQ(std::ranges::count(unsupportedOf(out.plan), 1), 0);
}

// The prime comes first, though it belongs to the first patch.
TEST(Underlay, FollowsThePrimeAndTheGrownPartIsThePlans) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, -12, 0.8, 0);
  plan.paths.front().kind = plan::PathKind::Skirt;
  addPath(plan, -15, 15, 2.4, 1.6, 0);
  for (plan::ToolPath& path : plan.paths)
    path.patch = 0;
  const Underlaid out = underlaid(plan);
  ASSERT_EQ(out.plan.paths.size(), 3u);
  EXPECT_EQ(out.plan.paths[0].kind, plan::PathKind::Skirt);
  EXPECT_EQ(out.plan.paths[1].kind, plan::PathKind::Support);

  plan::ToolPlan flat;
  addPath(flat, -15, 15, 0, 0.8, 0);
  const Underlaid same = underlaid(flat);
  EXPECT_EQ(same.underlaid, 0u);
  for (const Underlaid* of : {&out, &same}) {
    ASSERT_NE(of->grown, nullptr);
    const collision::GrowingPart fresh(
        of->plan, collision::growingPitch(of->plan, process::Tooling(kProcess)), {});
    ASSERT_EQ(of->grown->grid().size, fresh.grid().size);
    for (std::size_t c = 0; c < fresh.grid().cellCount(); ++c)
      ASSERT_EQ(of->grown->filledAt(c), fresh.filledAt(c));
  }
}

TEST(Underlay, NothingWhereTheRimBridgesOrThePlateIsFarOrNotThere) {
  plan::ToolPlan shortRim;
  addPath(shortRim, -1.2, 1.2, 0, 1.6, 0); // less than half of the bridging length
  EXPECT_EQ(underlaid(shortRim).underlaid, 0u);

  plan::ToolPlan high;
  addPath(high, -15, 15, 0, 0.8 + 6.0 * kProcess.beadWidthMaxMm + 0.1, 0);
  EXPECT_EQ(underlaid(high).underlaid, 0u);

  plan::ToolPlan shifted;
  addPath(shifted, -15, 15, 21, 1.6, 0);
  EXPECT_EQ(underlaid(shifted).underlaid, 0u);
  EXPECT_EQ(underlaid(shifted).plan.position, shifted.position);

  platform::PlatformSolid rod;
  rod.rod.emplace();
  EXPECT_EQ(underlaid(roundFoot(), rod).underlaid, 0u);
}

// Between existing walls the head would cut in: there a rim stays unsupported.
TEST(Underlay, NoSupportWhereItIsBlocked) {
  const plan::ToolPlan plan = roundFoot();
  toolpath::PassScene scene = sceneOn(kPlate);
  const auto phase = toolpath::PassPhase::BeforeDirections;
  const auto supports = [&] {
    std::vector<Vector3d> tips;
    const plan::ToolPlan made =
        toolpath::runUnsupportedPasses(phase, plan, upwards(phase, plan), nullptr, scene, {})
            .beads.plan;
    for (const plan::ToolPath& path : made.paths)
      if (path.kind == plan::PathKind::Support)
        for (std::size_t i = path.first; i < path.first + path.count; ++i)
          tips.push_back(made.position[i]);
    return tips;
  };
  EXPECT_EQ(supports().size(), 31u);
  scene.isBlocked = [](const plan::ToolPath&, const Vector3d& at) { return at.x() > 0.5; };
  const std::vector<Vector3d> left = supports();
  EXPECT_EQ(left.size(), 16u);
  for (const Vector3d& tip : left)
    EXPECT_LE(tip.x(), 0.5);
  // Asked of the middle of a bead of the rim.
  scene.isBlocked = [](const plan::ToolPath& path, const Vector3d& at) {
    return path.layer == 1 && std::abs(at.z() - 1.2) < 1e-6;
  };
  EXPECT_TRUE(supports().empty());
}

TEST(Underlay, NoSupportWhereTheHeadDoesNotFit) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 3; ++layer)
    for (const double y : {1.5, 3.5})
      addPath(plan, -5, 15, y, 0.8 * (layer + 1), layer);
  addPath(plan, -15, 15, 2.5, 1.6, 3);
  const Underlaid out = underlaid(plan);
  ASSERT_EQ(out.underlaid, 1u);
  for (const plan::ToolPath& path : out.plan.paths) {
    if (path.kind != plan::PathKind::Support)
      continue;
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      EXPECT_LT(out.plan.position[i].x(), -5.0);
  }
}

TEST(Underlay, SeveralCoursesWhereOneWouldBeThickerThanALayer) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 2.8, 0);
  const Underlaid out = underlaid(plan);
  ASSERT_EQ(out.plan.paths.size(), 3u);
  double top = 0.0;
  for (int c = 0; c < 2; ++c) {
    const std::size_t i = out.plan.paths[static_cast<std::size_t>(c)].first;
    const auto height = static_cast<double>(out.plan.heightMm[i]);
    EXPECT_LE(height, kProcess.layerHeightMaxMm);
    EXPECT_NEAR(out.plan.position[i].z() - height, top, 1e-6);
    top = out.plan.position[i].z();
  }
  EXPECT_NEAR(top, 2.0 - 0.8 / 14.0, 1e-6);
}

// A roof two layers over a slab, on posts' height: beads are stacked on the slab.
TEST(Underlay, IsStackedOnPrintedBeads) {
  plan::ToolPlan plan;
  for (int layer = 0; layer < 8; ++layer)
    addPath(plan, -15, 15, 0, 0.8 * (layer + 1), layer);
  addPath(plan, -15, 15, 0, 6.4 + 3.0, 8);
  const Underlaid out = underlaid(plan);
  EXPECT_EQ(out.underlaid, 1u);
  ASSERT_EQ(out.plan.paths.size(), 12u);
  double top = 6.4;
  for (std::size_t p = 8; p < 11; ++p) {
    const plan::ToolPath& under = out.plan.paths[p];
    EXPECT_EQ(under.kind, plan::PathKind::Support);
    const auto height = static_cast<double>(out.plan.heightMm[under.first]);
    // Printed beads are known by their cells.
    EXPECT_NEAR(out.plan.position[under.first].z() - height, top, 0.2);
    top = out.plan.position[under.first].z();
  }
  EXPECT_NEAR(top, 6.4 + 2.2 - 0.8 / 14.0, 1e-6);
  EXPECT_EQ(std::ranges::count(unsupportedOf(out.plan), 1), 0);
}

// A wall of support is a sixth of its height wide at least.
TEST(Underlay, HighOnesAreWider) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8 + 9.0, 0);
  const Underlaid out = underlaid(plan);
  ASSERT_EQ(out.plan.paths.size(), 10u);
  for (std::size_t p = 0; p < 9; ++p)
    EXPECT_NEAR(out.plan.widthMm[out.plan.paths[p].first], (9.0 - 0.8 / 14.0) / 6.0, 1e-6);
}

// Seen from the side: where the nozzle is inclined beside a wall, beads below are inclined too.
TEST(Underlay, LeansWhereTheHeadFitsOnlyInclined) {
  const Vector3d aslant = Vector3d(0.0, -1.0, 1.0).normalized();
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8, 0);
  for (int layer = 1; layer < 30; ++layer)
    addPath(plan, -15, 15, 2.4, 0.8 * layer, layer);
  addPath(plan, -15, 15, 0.0, 3.6, 30);
  const plan::ToolPath& roof = plan.paths.back();
  for (std::size_t i = roof.first; i < roof.first + roof.count; ++i)
    plan.direction[i] = aslant;
  const Underlaid out = underlaid(plan);
  std::size_t printed = 0;
  for (const plan::ToolPath& path : out.plan.paths) {
    if (path.kind != plan::PathKind::Support)
      continue;
    for (std::size_t i = path.first; i < path.first + path.count; ++i, ++printed)
      EXPECT_EQ(out.plan.direction[i], aslant);
  }
  EXPECT_GT(printed, 30u);
}

// Where the head cuts into a wall, upright and in the direction of the roof: leaning away from it.
TEST(Underlay, LeansAwayFromAWall) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8, 0);
  for (int layer = 1; layer <= 5; ++layer) // leans over towards the roof
    addPath(plan, -15, 15, 0.6 * layer, 0.8 * (layer + 1), layer);
  addPath(plan, -15, 15, 4.6, 0.8 * 6, 6);
  const Underlaid out = underlaid(plan);
  ASSERT_EQ(out.underlaid, 1u);
  for (const plan::ToolPath& path : out.plan.paths) {
    if (path.kind != plan::PathKind::Support)
      continue;
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      EXPECT_GT(out.plan.direction[i].y(), 0.3); // the wall is on the other side
  }
}

// From the last foot to the first bead of the patch, to and fro.
TEST(Underlay, RimSupportsOfOneHeightAreInTheOrderOfMinimumTravel) {
  plan::ToolPlan plan;
  for (const double y : {-12.0, -4.0, 4.0, 12.0})
    addPath(plan, -15, 0, y, 0.8, 0);
  for (const double y : {-12.0, 4.0, 12.0, -4.0})
    addPath(plan, -15, 15, y, 1.6, 1);
  const Underlaid out = underlaid(plan);
  EXPECT_EQ(out.underlaid, 4u);
  std::vector<plan::ToolPath> supports;
  std::ranges::copy_if(
      out.plan.paths, std::back_inserter(supports),
      [](const plan::ToolPath& path) { return path.kind == plan::PathKind::Support; });
  ASSERT_EQ(supports.size(), 4u);
  for (std::size_t k = 0; k < supports.size(); ++k) {
    const Vector3d& begin = out.plan.position[supports[k].first];
    EXPECT_DOUBLE_EQ(begin.y(), 12.0 - 8.0 * static_cast<double>(k));
    if (k > 0) {
      EXPECT_NEAR((begin - out.plan.position[supports[k].first - 1]).norm(), 8.0, 0.5);
    }
  }
}

// By the hundred: no bead is in one deposited before it, and none is unsupported.
TEST(Underlay, RandomFeet) {
  std::size_t printed = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution<>(from, to)(random);
    };
    plan::ToolPlan plan;
    for (int row = 0; row < 3; ++row) {
      const double from = number(-18, -2), y = -12.0 + 10.0 * row;
      addPath(plan, from, from + number(4, 18), y, 0.8, 0);
    }
    for (int row = 0; row < 6; ++row) {
      const double from = number(-18, -2), y = -12.0 + 5.0 * row + number(-0.3, 0.3);
      addPath(plan, from, from + number(4, 18), y, number(1.2, 2.8), 1 + row);
    }
    const Underlaid out = underlaid(plan);
    const double pitch = collision::growingPitch(out.plan, process::Tooling(kProcess));
    const collision::GrowingPart part(out.plan, pitch, {});
    plan::ToolPlan deeper = out.plan; // cells are known by their centres
    for (float& height : deeper.heightMm)
      height += static_cast<float>(0.5 * pitch);
    const std::vector<char> unsupported = unsupportedOf(deeper);
    for (const plan::ToolPath& path : out.plan.paths) {
      if (path.kind != plan::PathKind::Support)
        continue;
      ++printed;
      EXPECT_TRUE(
          toolpath::unsupportedStretches(out.plan, path, unsupported, kProcess.beadWidthMm).empty())
          << seed << ": " << out.plan.position[path.first].transpose();
      for (std::size_t i = path.first; i < path.first + path.count; ++i) {
        EXPECT_GE(out.plan.position[i].z() - static_cast<double>(out.plan.heightMm[i]), -1e-5);
        // Cells are known by their centres: half of one nearer to the bead below.
        const Vector3d middle =
            out.plan.position[i] +
            0.5 * (pitch - static_cast<double>(out.plan.heightMm[i])) * out.plan.direction[i];
        EXPECT_FALSE(part.holds(middle, path.first)) << seed << ": " << middle.transpose();
      }
    }
  }
  EXPECT_GT(printed, 100u);
}
